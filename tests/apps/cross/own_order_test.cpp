// An order of one's own, the shortcut by symmetry, and sheets on which pinned ends are released.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "apps/cross/document/file.h"
#include "apps/cross/session/own_order.h"
#include "apps/cross/session/report.h"

using namespace cross;
namespace fc = femoop::cross;

namespace {

std::string turns(const Session& session)
{
    std::string names;
    for (const fc::Step& step : session.sheet()->steps)
        names += session.document().model[session.solution().task->problem[*step.joint].node].id;
    return names;
}

std::string notes(const Session& session)
{
    std::string all;
    for (const std::string& note : table_of(session, Topic::Sheet).notes) all += note;
    return all;
}

} // namespace

TEST_CASE("Joints are balanced in the order that was typed, again and again")
{
    Session session;
    CHECK_FALSE(take_own_order(session, " C B  C "));
    CHECK(session.document().method.order == fc::Order::Listed);
    CHECK(own_order(session.document().method) == "C B C");
    for (int i = 0; i < 5; ++i) session.step();
    CHECK(turns(session) == "CBCBC"); // a joint that is balanced already is passed over
    CHECK_FALSE(take_own_order(session, "B,C"));
    CHECK(own_order(session.document().method) == "B C");
}

TEST_CASE("A name that is no joint and an order of nothing are refused and change nothing")
{
    Session session;
    const Method before = session.document().method;
    CHECK(ui::Catalogue()(*take_own_order(session, "B X")).find("X is no joint") == 0);
    CHECK(take_own_order(session, "A")); // pinned and modified: it is never locked
    CHECK(take_own_order(session, " , ;"));
    CHECK(take_own_order(session, ""));
    CHECK(session.document().method == before);
}

TEST_CASE("The order of one's own begins with every joint and is saved with the structure")
{
    Session session;
    choose_own_order(session);
    CHECK(own_order(session.document().method) == "B C");
    CHECK(read_document(write_document(session.document())).method == session.document().method);
}

TEST_CASE("A sheet on which pinned ends are released once is the same after it was saved")
{
    Document document = starting_document();
    document.method.far_ends = fc::FarEnds::ReleasedOnSheet;
    document.model.expected.clear();
    document.model.extra.clear();
    CHECK(read_document(write_document(document)).method.far_ends == fc::FarEnds::ReleasedOnSheet);
    document.method.far_ends = fc::FarEnds::Plain;
    CHECK(read_document(write_document(document)).method.far_ends == fc::FarEnds::Plain);
}

TEST_CASE("A symmetric frame is offered half of its joints with 2EI/L for the beam that crosses the axis")
{
    Session session;
    REQUIRE(session.open("examples/portal.json"));
    CHECK(notes(session).find("Symmetric about x = 4 m: it is enough to balance B") == 0);
    session.set_stage(1); // the sway alone
    CHECK(notes(session).find("By symmetry the loads do not cause this sway.") == 0);
    CHECK(notes(Session()).empty());
}

TEST_CASE("Half of a frame is worked, undone, saved and opened again; a frame that a hand makes uneven is worked whole")
{
    Session session;
    REQUIRE(session.open("examples/portal.json"));
    Method method = session.document().method;
    method.extent = fc::Extent::Half;
    session.set_method(method, "Change the method");
    CHECK(session.n_stages() == 1);
    CHECK(!session.step());
    CHECK(session.sheet()->is_balanced);
    CHECK(!session.balance(fc::JointId(1))); // a click on C turns B, its image
    CHECK(session.turn_tree()->turns() == std::vector<TurnTree::Turn>{fc::JointId(0), fc::JointId(0)});
    const Document again = read_document(write_document(session.document()));
    CHECK(again.method.extent == fc::Extent::Half);
    CHECK(again.plays.front().turns() == session.turn_tree()->turns());

    femoop::Model uneven = session.document().model;
    uneven.nodes[3].support = femoop::Support{.kind = femoop::SupportKind::Pin};
    session.change(uneven, "Change an end");
    REQUIRE(session.solution().task);
    CHECK(session.solution().task->problem.halves.empty());
    CHECK(session.solution().task->remarks.front().kind == femoop::FaultKind::CrossEndWithoutImage);
    CHECK(notes(session).find("the structure is not symmetric about x = 4 m: member end AB") == 0);
    session.undo();
    CHECK(session.solution().task->problem.halves.size() == 1);
    while (session.history().undo_label()) session.undo();
    CHECK(session.document().method.extent == fc::Extent::Whole);
}
