#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <string>

#include "apps/cross/session/beam_edit.h"
#include "apps/cross/session/commands.h"
#include "apps/cross/session/report.h"
#include "tests/apps/recovered.h"

using namespace cross;

TEST_CASE("A beam that a crash has cost opens as it was drawn, as one that is not saved")
{
    const Folder folder;
    Workspace workspace{Session()};
    CHECK(workspace.unsaved().empty());
    workspace.session.change(*with_span_added(workspace.session.document().model), "Add a span");
    CHECK(recovered(workspace, folder, ".json").session.document().model == workspace.session.document().model);
}

TEST_CASE("A draft that cannot be read leaves the open beam alone")
{
    const Folder folder;
    std::ofstream(folder.path() / "1-0.json") << "{";
    Workspace workspace{Session()};
    const femoop::Model before = workspace.session.document().model;
    CHECK(!workspace.recover({folder.path() / "1-0.json", {}}));
    CHECK(workspace.session.document().model == before);
    CHECK(!workspace.session.is_dirty());
    CHECK(workspace.session.notice);
}

TEST_CASE("All faults of a file are told at once, in the words of an app")
{
    Session session;
    CHECK_FALSE(session.open("tests/scenarios/many_faults.json"));
    const std::string told = session.tr()(session.notice->sentence);
    CHECK(told.starts_with("many_faults.json was not opened: "));
    CHECK(told.find("Node #10,") != std::string::npos);
    CHECK(told.find("Node #14,") != std::string::npos);
    CHECK(std::ranges::count(told, '\n') == 13);
}

TEST_CASE("Kani's method waits while a hand drags and is there once it lets go")
{
    Session session;
    session.drag(*with_span_added(session.document().model), "Add a span");
    CHECK(session.solution().task->comparison);
    CHECK(!session.solution().task->kani);
    session.settle();
    CHECK(session.solution().task->kani);
}

TEST_CASE("A sway that symmetric loads do not cause is said to be none, in the tables and beside the sheet")
{
    Session session;
    session.open("examples/portal_kleinlogel.json");
    REQUIRE(session.n_stages() == 3);
    const tabular::Table sways = table_of(session.scene(), Topic::Sways);
    CHECK(sways.notes.back() == "The loads cause no sway at B.");
    CHECK(shown_text(sways.rows[0].cells[1]) == "0 kN");
    session.set_stage(2);
    CHECK(shown_text(table_of(session.scene(), Topic::Sheet).rows[2].cells[0]) == "no sway at B");
}

TEST_CASE("What is in hand is told in the status line until it is put away")
{
    Session session;
    const std::string step = status_text(session);
    session.tool = Tool::UniformLoad;
    CHECK(status_text(session) == "a uniform load: click a member, or press Esc");
    session.tool = Tool::PointLoad;
    CHECK(status_text(session) == "a force: click a member or a node, or press Esc");
    session.tool = Tool::None;
    CHECK(status_text(session) == step);
}

TEST_CASE("Where little is to move a turn is done at once, and the next one waits as long as ever")
{
    Session session;
    session.is_playing = true;
    session.tick(0.1);
    CHECK(session.phase() < 1.0);
    session.is_still = true;
    const std::size_t n_solved = session.turn_tree()->length();
    session.tick(0.5);
    CHECK(session.phase() == 1.0);
    CHECK(session.turn_tree()->length() == n_solved);
    session.tick(0.8);
    session.tick(0.1);
    CHECK(session.turn_tree()->length() == n_solved + 1);
}
