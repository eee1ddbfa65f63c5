#include <doctest/doctest.h>

#include <random>
#include <string>
#include <vector>

#include "apps/euler/document/drawing/drawn_line.h"
#include "tests/apps/euler/first_solid.h"
#include "tests/samples.h"
#include "topology/halfedge/check/validate.h"
#include "topology/planar/planar_figure.h"
#include "ui/text/catalogue.h"

using namespace euler;
using topology::Point;

namespace {

std::optional<std::size_t> place(const Stepper& lesson)
{
    return lesson.runner().solids().empty() ? std::nullopt : std::optional<std::size_t>(0);
}

/// Draws, and gives the words that the lines begin with, or why not.
std::string draw(Stepper& lesson, const Point& from, const Point& to)
{
    const auto drawn = drawn_line(lesson, place(lesson), from, to);
    if (const auto* reason = std::get_if<ui::Message>(&drawn)) return ui::Catalogue()(*reason);
    std::string words;
    for (const DrawnStep& step : std::get<std::vector<DrawnStep>>(drawn)) {
        words += (words.empty() ? "" : " ") + step.line.substr(0, step.line.find(' '));
        REQUIRE_FALSE(lesson.apply(step.line));
        CHECK(ui::Catalogue(ui::Language::Portuguese).has(step.why.sentence));
        CHECK(ui::Catalogue()(step.why).find('{') == std::string::npos);
    }
    return words;
}

/// Every bounded face has its outer loop counter-clockwise and its rings clockwise; all loops of the face around do not
/// run counter-clockwise; and every loop lies in the face that surrounds it.
void require_planar(const topology::Solid& solid)
{
    const topology::Frame frame;
    const topology::PlanarFigure figure(solid, frame);
    const topology::FaceId around = figure.unbounded();
    for (const topology::FaceId f : solid.faces())
        for (const topology::LoopId l : solid.loops(f)) {
            const bool is_outer_of_region = f != around && solid.is_outer(l);
            REQUIRE((is_outer_of_region ? figure.area(l) > 1e-9 : figure.area(l) < 1e-9));
            if (is_outer_of_region || f == around) continue;
            REQUIRE(figure.winding(solid.outer(f), figure.flat(solid.start(solid.half_edge(l)))) == 1);
        }
}

void require_sound(const Stepper& lesson)
{
    REQUIRE_FALSE(topology::why_not_valid(first_solid(lesson)));
    const topology::EulerCounts counts = topology::euler_counts(first_solid(lesson));
    REQUIRE(counts.formula() == 0);
    REQUIRE(counts.S == 1);
    REQUIRE(counts.G == 0);
    require_planar(first_solid(lesson));
}

} // namespace

TEST_SUITE("drawn line")
{
    TEST_CASE("A triangle takes MVFS, MEV, MEV and an MEF whose new face is the region inside, either way around")
    {
        for (const bool is_clockwise : {false, true}) {
            Stepper lesson;
            const Point a{0, 0, 0}, b = is_clockwise ? Point{1, 5, 0} : Point{4, 0, 0},
                                    c = is_clockwise ? Point{4, 0, 0} : Point{1, 5, 0};
            CHECK(draw(lesson, a, b) == "mvfs mev");
            CHECK(draw(lesson, b, c) == "mev");
            CHECK(draw(lesson, c, a) == "mef");
            require_sound(lesson);
            const topology::Frame frame;
            const topology::FaceId made = *lesson.runner().solids().front().names.faces.find("f2", first_solid(lesson));
            CHECK(topology::PlanarFigure(first_solid(lesson), frame).area(made) == 10.0);
        }
    }

    TEST_CASE("A line apart begins with a lone vertex; one that joins it to the rest is MEKR; closing it is MEF")
    {
        Stepper lesson;
        draw(lesson, {0, 0, 0}, {9, 0, 0});
        CHECK(draw(lesson, {2, 2, 0}, {5, 2, 0}) == "mvr mev");
        CHECK(draw(lesson, {0, 0, 0}, {2, 2, 0}) == "mekr");
        CHECK(draw(lesson, {9, 0, 0}, {5, 2, 0}) == "mef");
        CHECK(draw(lesson, {5, 2, 0}, {2, 2, 0}) == "an edge is there already");
        CHECK(draw(lesson, {5, 2, 0}, {5, 2, 0}) == "the line has no length");
        CHECK(draw(lesson, {5, 2, 0}, {5, 2, 1}) == "the line leaves the plane of the figure");
        require_sound(lesson);
    }

    TEST_CASE("A line across an edge splits it, and a line through a vertex stops there")
    {
        Stepper lesson;
        draw(lesson, {0, 0, 0}, {8, 0, 0});
        CHECK(draw(lesson, {4, -3, 0}, {4, 3, 0}) == "semv mev mev");
        CHECK(draw(lesson, {0, 0, 0}, {4, 3, 0}) == "mef");
        CHECK(draw(lesson, {2, 0, 0}, {6, 0, 0}) == "semv semv"); // both ends in the middle of an edge, all of it there
        CHECK(first_solid(lesson).counts().faces == 2);
        require_sound(lesson);
    }

    TEST_CASE("A ring that comes to lie in the new face is taken there")
    {
        Stepper lesson;
        draw(lesson, {0, 0, 0}, {9, 0, 0});
        draw(lesson, {9, 0, 0}, {9, 9, 0});
        CHECK(draw(lesson, {4, 2, 0}, {6, 3, 0}) == "mvr mev");
        CHECK(draw(lesson, {9, 9, 0}, {0, 0, 0}) == "mef ringmv");
        require_sound(lesson);
        CHECK(draw(lesson, {7, 0.5, 0}, {8, 0.5, 0}) == "mvr mev");
        CHECK(draw(lesson, {0, 0, 0}, {4, 2, 0}) == "mekr");
        CHECK(draw(lesson, {6, 3, 0}, {9, 0, 0}).starts_with("mef")); // both parts are regions, the ring lies in one
        require_sound(lesson);
    }

    TEST_CASE("The oldest loop of the face around follows into a region that is drawn about it")
    {
        Stepper lesson;
        draw(lesson, {4, 2, 0}, {6, 3, 0});
        draw(lesson, {0, 0, 0}, {9, 0, 0});
        draw(lesson, {9, 0, 0}, {9, 9, 0});
        CHECK(draw(lesson, {9, 9, 0}, {0, 0, 0}) == "mekr kemr mef ringmv");
        require_sound(lesson);
    }

    TEST_CASE("Whatever lines are drawn, the figure stays a planar subdivision, and undo comes back to nothing")
    {
        for (unsigned seed = 1; seed <= samples(15, 6); ++seed) {
            CAPTURE(seed);
            std::mt19937 random(seed);
            const auto coordinate = [&] { return static_cast<double>(random() % 8); };
            Stepper lesson;
            for (int i = 0; i < 25; ++i) {
                const Point from{coordinate(), coordinate(), 0}, to{coordinate(), coordinate(), 0};
                CAPTURE(lesson.script());
                CAPTURE(from.x);
                CAPTURE(from.y);
                CAPTURE(to.x);
                CAPTURE(to.y);
                draw(lesson, from, to);
                if (place(lesson)) require_sound(lesson);
            }
            CHECK(first_solid(lesson).counts().faces > 8);
            lesson.go_to(0);
            CHECK(first_solid(lesson).is_empty());
        }
    }
}
