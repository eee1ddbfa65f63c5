#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "apps/frame/document/command.h"
#include "apps/frame/document/drawing.h"
#include "apps/frame/session/predict_commands.h"
#include "apps/frame/session/tabs.h"
#include "tests/source_folder.h"

using namespace frame;
using femoop::MemberId;

namespace {

constexpr MemberId BC{1};

Desk desk_with(const std::string& file)
{
    Desk desk{Session{Document{}}};
    REQUIRE(open_file(desk, source_folder() + "/examples/" + file));
    return desk;
}

std::optional<std::string> run(Desk& desk, std::string_view id)
{
    const auto reason = ui::run(*command_table().find(id), desk);
    return reason ? std::optional(ui::Catalogue()(*reason)) : std::nullopt;
}

void sketch(Desk& desk)
{
    const std::vector<StrokePoint> stroke{{0.0, -0.1}, {0.5, 0.1}, {1.0, -0.1}};
    desk.session.prediction.draw(desk.session.model(), desk.session.view.load_case, BC, stroke);
}

} // namespace

TEST_SUITE("frame session")
{
    TEST_CASE("To predict hides the results, and to reveal them shows the moments too where they were guessed")
    {
        Desk desk = desk_with("portal.json");
        desk.session.view.show = ShowSet{Show::Loads, Show::N};
        CHECK(!run(desk, "draw.predict"));
        CHECK(desk.hand.kind() == ToolKind::Predict);
        CHECK(desk.session.hidden);
        CHECK(desk.session.view.show == ShowSet{Show::Loads});
        sketch(desk);
        CHECK(!run(desk, "view.hide_results"));
        CHECK(desk.session.view.show == ShowSet{Show::Loads, Show::N, Show::M});
        CHECK(desk.hand.kind() == ToolKind::Select);
        CHECK(!desk.session.prediction.is_empty());
    }

    TEST_CASE("Why there are no results to read: they are hidden, or there are none")
    {
        Desk desk = desk_with("portal.json");
        CHECK(!desk.session.why_no_results());
        CHECK(!run(desk, "view.hide_results"));
        CHECK(ui::Catalogue()(*desk.session.why_no_results()) == "The results are hidden; H reveals them.");
        Desk mechanism = desk_with("mechanism.json");
        CHECK(ui::Catalogue()(*mechanism.session.why_no_results()) == "There are no results: see the problems.");
    }

    TEST_CASE("While results are hidden they are told in no words but those that say so")
    {
        Desk desk = desk_with("portal.json");
        const std::string with_results = desk.session.in_words();
        CHECK(with_results.find("58.5228") != std::string::npos); // kN m in the middle of the beam
        CHECK(!run(desk, "view.hide_results"));
        CHECK(!desk.session.told_results());
        const std::string without = desk.session.in_words();
        CHECK(without.find("58.5228") == std::string::npos);
        CHECK(without.find("12 kN/m") != std::string::npos);
        CHECK(without.ends_with("The results are hidden; H reveals them.\n"));
        CHECK(!run(desk, "view.hide_results"));
        CHECK(desk.session.in_words() == with_results);
    }

    TEST_CASE("Moments are not guessed in space, of a mechanism, nor of an envelope, and the reason is told")
    {
        Desk grillage = desk_with("grillage.json");
        CHECK(run(grillage, "draw.predict") == "moments are guessed on plane frames only");
        Desk truss = desk_with("truss.json");
        CHECK(run(truss, "draw.predict") == "moments are guessed on plane frames only");
        Desk mechanism = desk_with("mechanism.json");
        CHECK(run(mechanism, "draw.predict") == "the model has no results");
        Desk portal = desk_with("portal.json");
        CHECK(!run(portal, "view.envelope"));
        CHECK(run(portal, "draw.predict") == "an envelope is no diagram of one case; choose a case");
        CHECK(!portal.session.hidden);
    }

    TEST_CASE("Del and Esc wipe out the guess, then Esc lays the pencil down; the document stays as it is")
    {
        Desk desk = desk_with("portal.json");
        desk.session.selection = everything(desk.session.model());
        CHECK(!run(desk, "draw.predict"));
        sketch(desk);
        CHECK(!run(desk, "edit.delete"));
        CHECK(desk.session.prediction.is_empty());
        CHECK(desk.session.model().members.size() == 3);
        sketch(desk);
        CHECK(!run(desk, "edit.deselect"));
        CHECK(desk.session.prediction.is_empty());
        CHECK(desk.hand.kind() == ToolKind::Predict);
        CHECK(!run(desk, "edit.deselect"));
        CHECK(desk.hand.kind() == ToolKind::Select);
        CHECK(run(desk, "view.clear_guess") == "nothing was guessed yet");
        sketch(desk);
        CHECK(!run(desk, "view.clear_guess"));
        CHECK(desk.session.prediction.is_empty());
        CHECK(!desk.session.history().can_undo());
    }

    TEST_CASE("The guess goes with its member, is stale after a change and fresh again when that is undone")
    {
        Desk desk = desk_with("portal.json");
        sketch(desk);
        const auto is_stale = [&] {
            return desk.session.prediction.is_stale(desk.session.model(), desk.session.view.load_case);
        };
        desk.session.change({ui::translatable("Change"), [](Document& document) { set_title(document, "Other"); }});
        CHECK(is_stale());
        desk.session.undo();
        CHECK(!is_stale());
        desk.session.change(
            {ui::translatable("Change"), [](Document& document) { remove(document, std::vector<Part>{MemberId(0)}); }});
        CHECK(desk.session.prediction.on(MemberId(0)) != nullptr);
        CHECK(desk.session.prediction.on(BC) == nullptr);
        desk.session.change(
            {ui::translatable("Change"), [](Document& document) { remove(document, std::vector<Part>{MemberId(0)}); }});
        CHECK(desk.session.prediction.is_empty());
    }

    TEST_CASE("Each tab has its own guess, and opening a file drops it")
    {
        Desk desk = desk_with("portal.json");
        sketch(desk);
        REQUIRE(open_file(desk, source_folder() + "/examples/gerber_beam.json"));
        CHECK(desk.session.prediction.is_empty());
        show_tab(desk, 0);
        CHECK(!desk.session.prediction.is_empty());
        REQUIRE(desk.session.open(source_folder() + "/examples/portal.json"));
        CHECK(desk.session.prediction.is_empty());
    }
}
