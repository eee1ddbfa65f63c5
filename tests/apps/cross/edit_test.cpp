// What a hand changes of a structure.
#include <doctest/doctest.h>

#include "apps/cross/document/file.h"
#include "apps/cross/session/beam_edit.h"
#include "apps/cross/session/report.h"
#include "femoop/model/check/check.h"
#include "femoop/tabular/latex.h"

using namespace cross;
using femoop::Model;
using femoop::NodeId;

namespace {

Model beam() { return starting_document().model; }

double x_of(const Model& model, const char* node) { return model[*model.find_node(node)].at[0].value(); }

} // namespace

TEST_CASE("A support of a beam is dragged along it and never past its neighbours")
{
    const NodeId B = *beam().find_node("B");
    const auto next = with_node_at(beam(), B, {9.5, 3.0});
    REQUIRE(next);
    CHECK(x_of(*next, "B") == 9.5);
    CHECK((*next)[B].at[1].value() == 0.0);
    CHECK_FALSE(with_node_at(beam(), B, {14.0, 0.0}));
    CHECK_FALSE(with_node_at(beam(), B, {15.0, 0.0}));
    CHECK_FALSE(with_node_at(beam(), B, {-1.0, 0.0}));
}

TEST_CASE("A load that is pulled keeps its kind and changes its value")
{
    const Model next = with_load_scaled(beam(), frame::MemberLoadPlace{0, 1}, femoop::Dof::uy, 1.5);
    const auto& load = std::get<femoop::DistributedLoad>(next.load_cases[0].members[1].load);
    CHECK(load.values[0].start.value() == doctest::Approx(-57.0));
}

TEST_CASE("A span more is as long and as loaded as the last and is held as the end was")
{
    const auto next = with_span_added(beam());
    REQUIRE(next);
    CHECK(next->members.size() == 4);
    CHECK(x_of(*next, "E") == 26.0);
    CHECK(next->nodes.back().support->kind == femoop::SupportKind::Fixed);
    CHECK((*next)[*next->find_node("D")].support->kind == femoop::SupportKind::Roller);
    CHECK(next->load_cases[0].members.size() == 4);
    CHECK(femoop::check(*next).empty());
}

TEST_CASE("A span less brings back the beam before a span was added")
{
    const auto next = with_span_removed(*with_span_added(beam()));
    REQUIRE(next);
    CHECK(next->nodes == beam().nodes);
    CHECK(next->members == beam().members);
    CHECK(next->load_cases == beam().load_cases);
}

TEST_CASE("The last span cannot be removed")
{
    const auto one = with_span_removed(*with_span_removed(beam()));
    REQUIRE(one);
    CHECK_FALSE(with_span_removed(*one));
}

TEST_CASE("A frame's feet are no ends of spans, so none is added below them or taken away")
{
    Session session;
    for (const char* const path : {"examples/portal.json", "tests/cases/own/staged-two-storeys.json"}) {
        CAPTURE(path);
        REQUIRE(session.open(path));
        const Model& frame = session.document().model;
        for (const Side side : {Side::Left, Side::Right}) {
            CHECK_FALSE(end_of_spans(frame, side));
            CHECK_FALSE(with_span_added(frame, side));
            CHECK_FALSE(with_span_removed(frame, side));
        }
    }
}

TEST_CASE("An end is pinned then fixed then free")
{
    const NodeId A = *end_node(beam(), Side::Left);
    const Model fixed = with_next_support(beam(), A), free = with_next_support(fixed, A);
    CHECK(fixed[A].support->kind == femoop::SupportKind::Fixed);
    CHECK_FALSE(free[A].support);
    CHECK(with_next_support(free, A)[A].support->kind == femoop::SupportKind::Pin);
}

TEST_CASE("A support that is put between and taken away again leaves the beam as it was")
{
    const femoop::MemberId CD = *beam().find_member("CD");
    const auto next = with_support_between(beam(), CD, 2.5);
    REQUIRE(next);
    REQUIRE(next->members.size() == 4);
    const NodeId added(next->nodes.size() - 1);
    CHECK((*next)[added].at[0].value() == 16.5);
    CHECK((*next)[added].support->kind == femoop::SupportKind::Roller);
    const Model again = with_support_taken(*next, added);
    CHECK(again.nodes == beam().nodes);
    CHECK(again.members == beam().members);
    CHECK(again.load_cases == beam().load_cases);
}

TEST_CASE("No support goes onto an end of a member or under an upright one")
{
    CHECK_FALSE(with_support_between(beam(), femoop::MemberId(0), 0.0));
    CHECK_FALSE(with_support_between(beam(), femoop::MemberId(0), 8.0));
    const Model portal = read_document_file("examples/portal.json").model;
    CHECK_FALSE(with_support_between(portal, *portal.find_member("AB"), 2.0));
    CHECK(with_support_between(portal, *portal.find_member("BC"), 2.0));
}

TEST_CASE("An end without its support overhangs and an inner one makes one span of two")
{
    const Model overhang = with_support_taken(beam(), *beam().find_node("A"));
    CHECK(overhang.members.size() == 3);
    CHECK_FALSE(overhang[*overhang.find_node("A")].support);
    CHECK(with_support_taken(beam(), *beam().find_node("B")).nodes.size() == 3);
}

TEST_CASE("A span more at the left is as long as is asked for and the outer end is held as it was")
{
    const auto next = with_span_added(beam(), Side::Left, 3.5);
    REQUIRE(next);
    const NodeId end = *end_node(*next, Side::Left);
    CHECK((*next)[end].at[0].value() == -3.5);
    CHECK((*next)[end].support->kind == femoop::SupportKind::Pin);
    CHECK(with_span_removed(*next, Side::Left)->nodes.size() == 4);
}

TEST_CASE("A point load is moved along its member in tenths and never off it")
{
    Model model = beam();
    model.load_cases[0].members.push_back(
        {femoop::MemberId(0), femoop::PointLoad{.at = femoop::Percent{50.0}, .components = {{femoop::Dof::uy, -7.0}}}});
    const frame::Part load = frame::MemberLoadPlace{0, model.load_cases[0].members.size() - 1};
    const auto moved = with_point_load_moved(model, load, 1.23);
    REQUIRE(moved);
    const auto& point = std::get<femoop::PointLoad>(moved->load_cases[0].members.back().load);
    CHECK(std::get<femoop::Quantity>(point.at).value() == doctest::Approx(5.2));
    CHECK_FALSE(with_point_load_moved(model, load, 4.2));
    CHECK_FALSE(with_point_load_moved(model, frame::MemberLoadPlace{0, 0}, 1.0));
}

TEST_CASE("A structure that was changed no longer carries what was expected of the former")
{
    REQUIRE_FALSE(beam().expected.empty());
    CHECK(with_span_added(beam())->expected.empty());
    CHECK(with_span_added(beam())->extra.empty());
}

TEST_CASE("A sheet in LaTeX has a column for every end and one for the row's name")
{
    const Session session;
    const tabular::Table table = table_of(session, Topic::Sheet);
    CHECK(labels(table) == std::vector<std::string>{"Row", "AB", "BA", "BC", "CB", "CD", "DC"});
    CHECK(latex(table).starts_with("\\begin{tabular}{lrrrrrr}"));
    CHECK(separated(table, separators(ui::Language::English)).find("FEM,0.00,-64.00,114.00,-114.00,84.00,-84.00\n") !=
          std::string::npos);
    CHECK(separated(table, separators(ui::Language::Portuguese)).find("FEM;0.00;-64.00;") != std::string::npos);
}

TEST_CASE("Every table has rows as long as its head for a frame that sways")
{
    Session session;
    REQUIRE(session.open("examples/portal.json"));
    for (const TopicEntry& entry : topics()) {
        CAPTURE(std::string(entry.id));
        const tabular::Table table = table_of(session, entry.value);
        for (const auto& row : table.rows) CHECK(row.cells.size() == table.columns.size());
    }
}
