#include <doctest/doctest.h>

#include <string>

#include "apps/frame/document/command.h"
#include "apps/frame/session/solver_commands.h"
#include "apps/frame/session/tabs.h"
#include "tests/source_folder.h"

using namespace frame;
using femoop::Ordering;

namespace {

Desk desk_with(const std::string& file)
{
    Desk desk{Session{Document{}}};
    REQUIRE(open_file(desk, source_folder() + "/examples/" + file));
    return desk;
}

std::string run(Desk& desk, std::string_view id)
{
    const auto reason = ui::run(*command_table().find(id), desk);
    return reason ? ui::Catalogue()(*reason) : "";
}

} // namespace

TEST_SUITE("frame session")
{
    TEST_CASE("The solver's steps are commands: they stop at the first and the last front, in any order")
    {
        Desk desk = desk_with("storey_frame.json");
        CHECK(run(desk, "solver.next") == "the solver is not shown; Ctrl+F4 shows it");
        CHECK(run(desk, "view.solver") == "");
        CHECK(desk.solver.ordering() == Ordering::CuthillMcKee);
        CHECK(desk.solver.n_steps() == 30);
        CHECK(run(desk, "solver.previous") == "");
        CHECK(desk.solver.step() == 0);
        CHECK(run(desk, "solver.last") == "");
        CHECK(run(desk, "solver.next") == "");
        CHECK(desk.solver.step() == 29);
        CHECK(run(desk, "solver.nested_dissection") == "");
        CHECK(desk.solver.n_steps() == 24);
        CHECK(desk.solver.step() == 23);
    }

    TEST_CASE("The front walks by itself, a step in 0.8 s, rests at the last and begins again from there")
    {
        Desk desk = desk_with("pratt_truss.json");
        run(desk, "view.solver");
        run(desk, "solver.nested_dissection");
        REQUIRE(desk.solver.n_steps() == 6);
        run(desk, "solver.play");
        for (int frame = 0; frame < 100; ++frame) desk.solver.advance(1.0 / 60.0);
        CHECK(desk.solver.step() == 2);
        for (int frame = 0; frame < 600; ++frame) desk.solver.advance(1.0 / 60.0);
        CHECK(desk.solver.step() == 5);
        CHECK_FALSE(desk.solver.is_playing());
        run(desk, "solver.play");
        CHECK(desk.solver.step() == 0);
        run(desk, "solver.next");
        CHECK_FALSE(desk.solver.is_playing());
    }

    TEST_CASE("What has no front that walks says why: a mechanism, one with errors, too many nodes")
    {
        Desk desk = desk_with("mechanism.json");
        run(desk, "view.solver");
        CHECK(desk.solver.trace() == nullptr);
        CHECK(ui::Catalogue()(desk.solver.why_none().value()) ==
              "The structure cannot be solved, so no front walks: see the problems.");
        CHECK(run(desk, "solver.next") == "there is no front that walks");
        Document many;
        for (int i = 0; i < 2001; ++i)
            many.model.add(
                femoop::Node{.id = std::to_string(i), .at = {femoop::Quantity(1.0 * i), femoop::Quantity(0.0)}});
        desk.session = Session(many);
        desk.solver.follow(desk.session);
        CHECK(desk.solver.trace() == nullptr);
        CHECK(ui::Catalogue()(desk.solver.why_none().value()).starts_with("The model has 2001 nodes"));
    }

    TEST_CASE("An empty document, and a structure that is held everywhere, have nothing to eliminate")
    {
        Desk desk{Session{Document{}}};
        run(desk, "view.solver");
        CHECK(desk.solver.n_steps() == 0);
        desk = desk_with("portal.json");
        desk.session.change({"Hold all", [](Document& document) {
                                 for (femoop::Node& node : document.model.nodes)
                                     node.support = femoop::Support{.kind = femoop::SupportKind::Fixed};
                             }});
        desk.solver.follow(desk.session);
        CHECK(desk.solver.n_steps() == 0);
    }

    TEST_CASE("F4 goes from the solver to the tables, and from there it closes them")
    {
        Desk desk = desk_with("portal.json");
        run(desk, "view.solver");
        run(desk, "view.tables");
        CHECK(desk.bottom.shows(BottomContent::Table));
        run(desk, "view.tables");
        CHECK_FALSE(desk.bottom.is_open);
    }
}
