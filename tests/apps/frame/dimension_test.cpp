#include <doctest/doctest.h>

#include <array>
#include <numbers>

#include "apps/frame/document/dimensioning.h"
#include "apps/frame/document/drawing.h"

using Eigen::Vector2d;
using femoop::NodeId;
using frame::DimensionDirection;
using frame::DimensionLine;
using frame::Document;

namespace {

/// The portal of the app, A (0, 0), B (0, 4), C (6, 4), D (6, 0), with C dragged to (7, 6).
Document slanted()
{
    Document document = frame::starting_document();
    document.model.nodes[2].at = {7.0, 6.0, 0.0};
    return document;
}

DimensionLine between(const char* a, const char* b, DimensionDirection direction, double offset)
{
    return {.nodes = {a, b}, .direction = direction, .offset = offset};
}

double length(const Document& document, const DimensionLine& line)
{
    const auto layout = layout_of(document.model, line);
    REQUIRE(layout);
    return layout->marks.back().level - layout->marks.front().level;
}

constexpr auto aligned = DimensionDirection::Aligned, horizontal = DimensionDirection::Horizontal,
               vertical = DimensionDirection::Vertical;

} // namespace

TEST_SUITE("frame document")
{
    TEST_CASE("A dimension line measures between its nodes along its own direction")
    {
        const Document document = slanted(); // from B to C: 7 to the right and 2 up
        CHECK(length(document, between("B", "C", horizontal, 1.5)) == doctest::Approx(7.0));
        CHECK(length(document, between("B", "C", vertical, 1.5)) == doctest::Approx(2.0));
        CHECK(length(document, between("B", "C", aligned, 1.5)) == doctest::Approx(std::sqrt(53.0)));
    }

    TEST_CASE("A line lies at its offset from the first node, to the left of its direction")
    {
        const Document document = slanted();
        const auto above = layout_of(document.model, between("B", "C", horizontal, 1.5));
        CHECK(above->marks[0].foot.isApprox(Vector2d(0.0, 5.5)));
        CHECK(above->marks[1].foot.isApprox(Vector2d(7.0, 5.5)));
        const auto left = layout_of(document.model, between("B", "C", vertical, 1.5));
        CHECK(left->marks[0].foot.isApprox(Vector2d(-1.5, 4.0)));
        const auto beside = layout_of(document.model, between("B", "C", aligned, 1.5));
        CHECK((beside->marks[0].foot - Vector2d(0.0, 4.0)).norm() == doctest::Approx(1.5));
        CHECK((beside->marks[0].foot - Vector2d(0.0, 4.0)).dot(Vector2d(7.0, 2.0)) == doctest::Approx(0.0));
        CHECK(*offset_through(document.model, between("B", "C", aligned, 0.0), beside->marks[1].foot) ==
              doctest::Approx(1.5));
    }

    TEST_CASE("The side on which the hand is decides the direction, and no line measures nothing")
    {
        const femoop::Model model = slanted().model; // the middle of B and C is (3.5, 5)
        const DimensionLine line = between("B", "C", aligned, 0.0);
        CHECK(direction_meant(model, line, {3.5, 9.0}) == horizontal);
        CHECK(direction_meant(model, line, {4.5, 1.0}) == aligned); // square to the member
        CHECK(direction_meant(model, line, {9.0, 5.0}) == vertical);
        CHECK(direction_meant(model, between("A", "D", aligned, 0.0), {20.0, 0.1}) == horizontal);
        CHECK(direction_meant(model, between("A", "B", aligned, 0.0), {0.1, 20.0}) == vertical);
    }

    TEST_CASE("The nodes of a chain stand in their order along the line, however they were clicked")
    {
        Document document = slanted();
        const auto place = add_dimension(document, between("D", "A", horizontal, -1.0));
        continue_dimension(document, place, "C");
        continue_dimension(document, place, "C");
        const auto layout = layout_of(document.model, document.companion.dimensions[0]);
        REQUIRE(layout->marks.size() == 3);
        CHECK(layout->marks[0].level == 0.0);
        CHECK(layout->marks[1].level == 6.0);
        CHECK(layout->marks[2].level == 7.0);
    }

    TEST_CASE("A dimension line goes with a node of its two, and a chain closes over one that goes")
    {
        Document document = slanted();
        add_dimension(document, between("A", "D", horizontal, -1.0));
        add_dimension(document, {.nodes = {"B", "C", "D"}, .direction = vertical, .offset = 0.7});
        frame::remove(document, std::array{frame::Part(NodeId(2))});
        REQUIRE(document.companion.dimensions.size() == 2);
        CHECK(document.companion.dimensions[1].nodes == std::vector<std::string>{"B", "D"});
        frame::remove(document, std::array{frame::Part(NodeId(0))});
        REQUIRE(document.companion.dimensions.size() == 1);
        frame::remove(document, std::array{frame::Part(frame::DimensionPlace{0})});
        CHECK(document.companion.is_empty());
    }

    TEST_CASE("A dimension line follows a node that is given another name")
    {
        Document before = slanted();
        add_dimension(before, between("A", "D", horizontal, -1.0));
        Document after = before;
        after.model.nodes[3].id = "foot";
        follow(after.companion, before.model, after.model);
        CHECK(after.companion.dimensions[0].nodes == std::vector<std::string>{"A", "foot"});
    }

    TEST_CASE("Where one node lands on another, the line goes on to the one that is left")
    {
        Document document = slanted();
        add_dimension(document, between("B", "C", horizontal, 1.0));
        const std::size_t n = document.model.nodes.size();
        frame::add_node(document, {9.0, 9.0});
        const std::string other = document.model.nodes.back().id;
        add_dimension(document, between("A", other.c_str(), horizontal, 1.0));
        const femoop::Model before = document.model;
        frame::place(document, std::array{frame::Part(NodeId(n))}, femoop::moved_by({-2.0, -3.0, 0.0})); // on C
        frame::join(document, before);
        CHECK(document.model.nodes.size() == n);
        CHECK(document.companion.dimensions[1].nodes == std::vector<std::string>{"A", "C"});
    }

    TEST_CASE("A structure that is turned or mirrored keeps its dimension lines on their side")
    {
        Document document = slanted();
        add_dimension(document, between("A", "D", horizontal, -1.0)); // below
        add_dimension(document, between("B", "C", aligned, 0.8));     // outside
        const std::array all{frame::Part(NodeId(0)), frame::Part(NodeId(1)), frame::Part(NodeId(2)),
                             frame::Part(NodeId(3))};
        Document turned = document;
        frame::place(turned, all, femoop::turned({0.0, 0.0, 0.0}, 0.5 * std::numbers::pi));
        CHECK(turned.companion.dimensions[0].direction == vertical);
        CHECK(turned.companion.dimensions[0].offset == doctest::Approx(-1.0)); // below is now at the right
        CHECK(turned.companion.dimensions[1].offset == doctest::Approx(0.8));
        Document mirrored = document;
        frame::place(mirrored, all, femoop::mirrored({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}));
        CHECK(mirrored.companion.dimensions[0].offset == doctest::Approx(1.0)); // above
        CHECK(mirrored.companion.dimensions[1].offset == doctest::Approx(-0.8));
    }

    TEST_CASE("A copy of two nodes has a copy of the line between them")
    {
        Document document = slanted();
        add_dimension(document, between("A", "D", horizontal, -1.0));
        add_dimension(document, between("B", "C", horizontal, 1.0));
        const std::array columns{frame::Part(femoop::MemberId(0)), frame::Part(femoop::MemberId(2))};
        frame::copy(document, columns, femoop::moved_by({20.0, 0.0, 0.0}));
        REQUIRE(document.companion.dimensions.size() == 4);
        CHECK(length(document, document.companion.dimensions[2]) == doctest::Approx(6.0));
        frame::copy(document, std::array{frame::Part(NodeId(0))}, femoop::moved_by({-5.0, 0.0, 0.0}));
        CHECK(document.companion.dimensions.size() == 4);
    }
}
