#include <doctest/doctest.h>

#include <string>

#include "apps/frame/document/command.h"
#include "apps/frame/session/solver_commands.h"
#include "apps/frame/session/tabs.h"
#include "tests/apps/frame/example_workspace.h"

using namespace frame;
using femoop::Ordering;
using frame_test::workspace_with;

namespace {

std::string reason_of(Workspace& workspace, std::string_view id)
{
    const auto reason = ui::run(*command_table().find(id), workspace);
    return reason ? ui::Catalogue()(*reason) : "";
}

} // namespace

TEST_SUITE("frame session")
{
    TEST_CASE("The solver's steps are commands: they stop at the first and the last front, in any order")
    {
        Workspace workspace = workspace_with("storey_frame.json");
        CHECK(reason_of(workspace, "solver.next") == "the solver is not shown; Ctrl+F4 shows it");
        CHECK(reason_of(workspace, "view.solver") == "");
        CHECK(workspace.solver.ordering() == Ordering::CuthillMcKee);
        CHECK(workspace.solver.n_steps() == 30);
        CHECK(reason_of(workspace, "solver.previous") == "");
        CHECK(workspace.solver.step() == 0);
        CHECK(reason_of(workspace, "solver.last") == "");
        CHECK(reason_of(workspace, "solver.next") == "");
        CHECK(workspace.solver.step() == 29);
        CHECK(reason_of(workspace, "solver.nested_dissection") == "");
        CHECK(workspace.solver.n_steps() == 24);
        CHECK(workspace.solver.step() == 23);
    }

    TEST_CASE("The front walks by itself, a step in 0.8 s, rests at the last and begins again from there")
    {
        Workspace workspace = workspace_with("pratt_truss.json");
        reason_of(workspace, "view.solver");
        reason_of(workspace, "solver.nested_dissection");
        REQUIRE(workspace.solver.n_steps() == 6);
        reason_of(workspace, "solver.play");
        for (int frame = 0; frame < 100; ++frame) workspace.solver.advance(1.0 / 60.0);
        CHECK(workspace.solver.step() == 2);
        for (int frame = 0; frame < 600; ++frame) workspace.solver.advance(1.0 / 60.0);
        CHECK(workspace.solver.step() == 5);
        CHECK_FALSE(workspace.solver.is_playing());
        reason_of(workspace, "solver.play");
        CHECK(workspace.solver.step() == 0);
        reason_of(workspace, "solver.next");
        CHECK_FALSE(workspace.solver.is_playing());
    }

    TEST_CASE("What has no front that walks says why: a mechanism, one with errors, too many nodes")
    {
        Workspace workspace = workspace_with("mechanism.json");
        reason_of(workspace, "view.solver");
        CHECK(workspace.solver.trace() == nullptr);
        CHECK(ui::Catalogue()(workspace.solver.why_none().value()) ==
              "The structure cannot be solved, so no front walks: see the problems.");
        CHECK(reason_of(workspace, "solver.next") == "there is no front that walks");
        Document many;
        for (int i = 0; i < 2001; ++i)
            many.model.add(
                femoop::Node{.id = std::to_string(i), .at = {femoop::Quantity(1.0 * i), femoop::Quantity(0.0)}});
        workspace.session = Session(many);
        workspace.solver.follow(workspace.session);
        CHECK(workspace.solver.trace() == nullptr);
        CHECK(ui::Catalogue()(workspace.solver.why_none().value()).starts_with("The model has 2001 nodes"));
    }

    TEST_CASE("An empty document, and a structure that is held everywhere, have nothing to eliminate")
    {
        Workspace workspace{Session{Document{}}};
        reason_of(workspace, "view.solver");
        CHECK(workspace.solver.n_steps() == 0);
        workspace = workspace_with("portal.json");
        workspace.session.change({"Hold all", [](Document& document) {
                                      for (femoop::Node& node : document.model.nodes)
                                          node.support = femoop::Support{.kind = femoop::SupportKind::Fixed};
                                  }});
        workspace.solver.follow(workspace.session);
        CHECK(workspace.solver.n_steps() == 0);
    }

    TEST_CASE("F4 goes from the solver to the tables, and from there it closes them")
    {
        Workspace workspace = workspace_with("portal.json");
        reason_of(workspace, "view.solver");
        reason_of(workspace, "view.tables");
        CHECK(workspace.bottom.shows(BottomContent::Table));
        reason_of(workspace, "view.tables");
        CHECK_FALSE(workspace.bottom.is_open);
    }
}
