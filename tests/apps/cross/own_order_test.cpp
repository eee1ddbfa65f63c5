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
    CHECK(notes(session).find("Symmetric: it is enough to balance B, with BC 2EI/L and nothing carried over") == 0);
    session.set_stage(1); // the sway alone
    CHECK(notes(session).find("Antisymmetric: it is enough to balance B, with BC 6EI/L") == 0);
    CHECK(notes(Session()).empty());
}
