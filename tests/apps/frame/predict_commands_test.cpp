#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "apps/frame/document/command.h"
#include "apps/frame/document/drawing.h"
#include "apps/frame/session/predict_commands.h"
#include "apps/frame/session/tabs.h"
#include "tests/apps/frame/example_workspace.h"
#include "tests/source_folder.h"

using namespace frame;
using femoop::MemberId;
using frame_test::run;
using frame_test::workspace_with;

namespace {

constexpr MemberId predicted_beam{1};

void sketch(Workspace& workspace)
{
    const std::vector<StrokePoint> stroke{{0.0, -0.1}, {0.5, 0.1}, {1.0, -0.1}};
    workspace.session.prediction.draw(workspace.session.model(), workspace.session.view.load_case, predicted_beam,
                                      stroke);
}

} // namespace

TEST_SUITE("frame session")
{
    TEST_CASE("To predict hides the results, and to reveal them shows the moments too where they were guessed")
    {
        Workspace workspace = workspace_with("portal.json");
        workspace.session.view.show = ShowSet{Show::Loads, Show::N};
        CHECK(!run(workspace, "draw.predict"));
        CHECK(workspace.tool_controller.kind() == ToolKind::Predict);
        CHECK(workspace.session.hidden);
        CHECK(workspace.session.view.show == ShowSet{Show::Loads});
        sketch(workspace);
        CHECK(!run(workspace, "view.hide_results"));
        CHECK(workspace.session.view.show == ShowSet{Show::Loads, Show::N, Show::M});
        CHECK(workspace.tool_controller.kind() == ToolKind::Select);
        CHECK(!workspace.session.prediction.is_empty());
    }

    TEST_CASE("Why there are no results to read: they are hidden, or there are none")
    {
        Workspace workspace = workspace_with("portal.json");
        CHECK(!workspace.session.why_no_results());
        CHECK(!run(workspace, "view.hide_results"));
        CHECK(ui::Catalogue()(*workspace.session.why_no_results()) == "The results are hidden; H reveals them.");
        Workspace mechanism = workspace_with("mechanism.json");
        CHECK(ui::Catalogue()(*mechanism.session.why_no_results()) == "There are no results: see the problems.");
    }

    TEST_CASE("While results are hidden they are told in no words but those that say so")
    {
        Workspace workspace = workspace_with("portal.json");
        const std::string with_results = description(workspace.session);
        CHECK(with_results.find("58.5228") != std::string::npos); // kN m in the middle of the beam
        CHECK(!run(workspace, "view.hide_results"));
        CHECK(!workspace.session.described_results());
        const std::string without = description(workspace.session);
        CHECK(without.find("58.5228") == std::string::npos);
        CHECK(without.find("12 kN/m") != std::string::npos);
        CHECK(without.ends_with("The results are hidden; H reveals them.\n"));
        CHECK(!run(workspace, "view.hide_results"));
        CHECK(description(workspace.session) == with_results);
    }

    TEST_CASE("Why there are no results is told in words")
    {
        const std::string words = description(workspace_with("mechanism.json").session);
        CHECK(words.find("There are no results: see the problems.\n") != std::string::npos);
        CHECK(words.find("nodes B and C sway to the right together") != std::string::npos);
    }

    TEST_CASE("What is doubtful about the results is told in words, too")
    {
        const Workspace workspace = workspace_with("portal.json");
        CHECK(description(workspace.session).find("warning") == std::string::npos);
        Document soft{workspace.session.model()};
        soft.model.materials[0].E = 1e-3;
        CHECK(description(Session(soft)).find("warning: node ") != std::string::npos);
    }

    TEST_CASE("Moments are not guessed in space, of a mechanism, nor of an envelope, and the reason is told")
    {
        Workspace grillage = workspace_with("grillage.json");
        CHECK(run(grillage, "draw.predict") == "moments are guessed on plane frames only");
        Workspace truss = workspace_with("truss.json");
        CHECK(run(truss, "draw.predict") == "moments are guessed on plane frames only");
        Workspace mechanism = workspace_with("mechanism.json");
        CHECK(run(mechanism, "draw.predict") == "the model has no results");
        Workspace portal = workspace_with("portal.json");
        CHECK(!run(portal, "view.envelope"));
        CHECK(run(portal, "draw.predict") == "an envelope is no diagram of one case; choose a case");
        CHECK(!portal.session.hidden);
    }

    TEST_CASE("An influence line is sketched in a grillage and in space too")
    {
        for (const char* const file : {"grillage.json", "balcony.json"}) {
            CAPTURE(file);
            Workspace workspace = workspace_with(file);
            workspace.session.influence.ask(workspace.session.model(), drawing::Cut{MemberId(0), 0.5});
            CHECK(!run(workspace, "draw.predict"));
            CHECK(workspace.session.hidden);
        }
    }

    TEST_CASE("Del and Esc wipe out the guess, then Esc lays the pencil down; the document stays as it is")
    {
        Workspace workspace = workspace_with("portal.json");
        workspace.session.selection = everything(workspace.session.model());
        CHECK(!run(workspace, "draw.predict"));
        sketch(workspace);
        CHECK(!run(workspace, "edit.delete"));
        CHECK(workspace.session.prediction.is_empty());
        CHECK(workspace.session.model().members.size() == 3);
        sketch(workspace);
        CHECK(!run(workspace, "edit.deselect"));
        CHECK(workspace.session.prediction.is_empty());
        CHECK(workspace.tool_controller.kind() == ToolKind::Predict);
        CHECK(!run(workspace, "edit.deselect"));
        CHECK(workspace.tool_controller.kind() == ToolKind::Select);
        CHECK(run(workspace, "view.clear_guess") == "nothing was guessed yet");
        sketch(workspace);
        CHECK(!run(workspace, "view.clear_guess"));
        CHECK(workspace.session.prediction.is_empty());
        CHECK(!workspace.session.history().can_undo());
    }

    TEST_CASE("The guess goes with its member, is stale after a change and fresh again when that is undone")
    {
        Workspace workspace = workspace_with("portal.json");
        sketch(workspace);
        const auto is_stale = [&] {
            return workspace.session.prediction.is_stale(workspace.session.model(), workspace.session.view.load_case);
        };
        workspace.session.change(
            {ui::translatable("Change"), [](Document& document) { set_title(document, "Other"); }});
        CHECK(is_stale());
        workspace.session.undo();
        CHECK(!is_stale());
        workspace.session.change(
            {ui::translatable("Change"), [](Document& document) { remove(document, std::vector<Part>{MemberId(0)}); }});
        CHECK(workspace.session.prediction.on(MemberId(0)) != nullptr);
        CHECK(workspace.session.prediction.on(predicted_beam) == nullptr);
        workspace.session.change(
            {ui::translatable("Change"), [](Document& document) { remove(document, std::vector<Part>{MemberId(0)}); }});
        CHECK(workspace.session.prediction.is_empty());
    }

    TEST_CASE("Each tab has its own guess, and opening a file drops it")
    {
        Workspace workspace = workspace_with("portal.json");
        sketch(workspace);
        REQUIRE(open_file(workspace, source_folder() + "/examples/gerber_beam.json"));
        CHECK(workspace.session.prediction.is_empty());
        show_tab(workspace, 0);
        CHECK(!workspace.session.prediction.is_empty());
        REQUIRE(workspace.session.open(source_folder() + "/examples/portal.json"));
        CHECK(workspace.session.prediction.is_empty());
    }
}
