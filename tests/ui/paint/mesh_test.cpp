#include "ui/paint/mesh/polygon_mesh.h"
#include "ui/paint/mesh/simplified.h"
#include "ui/paint/mesh/stroke_mesh.h"
#include "ui/paint/mesh/trapezoids.h"

#include <doctest/doctest.h>
#include <stdexcept>

#include <algorithm>
#include <numbers>
#include <string>

using doctest::Approx;

namespace {

/// Ink on the paper: the coverage summed over a fine grid [px^2].
double ink(const ui::Mesh& mesh, const ui::Box& sheet)
{
    constexpr double step = 0.25;
    double sum = 0.0;
    for (double y = sheet.min.y + step / 2; y < sheet.max.y; y += step)
        for (double x = sheet.min.x + step / 2; x < sheet.max.x; x += step) sum += mesh.coverage_at({x, y});
    return sum * step * step;
}

ui::Mesh stroked(std::vector<ui::Point> points, const ui::StrokeShape& shape, ui::PathEnds ends = ui::PathEnds::Open)
{
    ui::Mesh mesh;
    ui::add_stroke(mesh, points, ends, shape);
    return mesh;
}

ui::Mesh filled(std::vector<ui::Point> points)
{
    ui::Mesh mesh;
    ui::add_fill(mesh, points);
    return mesh;
}

const ui::Box sheet{{0.0, 0.0}, {60.0, 60.0}};

} // namespace

TEST_SUITE_BEGIN("mesh");

TEST_CASE("A line spends its length times its width of ink, thin, thick or slanted")
{
    const ui::Point a{10.3, 12.7}, b{43.1, 31.9};
    const double length = ui::distance(a, b);
    for (const double width : {0.4, 1.0, 1.7, 3.0, 9.0}) {
        CAPTURE(width);
        CHECK(ink(stroked({a, b}, {.width = width}), sheet) == Approx(length * width).epsilon(0.02));
    }
}

TEST_CASE("A square cap adds a width of length, a round one a disc in two halves")
{
    const ui::Point a{15.0, 30.0}, b{43.0, 25.0};
    const double length = ui::distance(a, b), width = 8.0;
    CHECK(ink(stroked({a, b}, {.width = width, .cap = ui::Cap::Square}), sheet) ==
          Approx((length + width) * width).epsilon(0.02));
    CHECK(ink(stroked({a, b}, {.width = width, .cap = ui::Cap::Round}), sheet) ==
          Approx(length * width + std::numbers::pi * width * width / 4.0).epsilon(0.02));
}

TEST_CASE("At a right angle a mitre fills the corner, a bevel cuts half a square, a round join leaves a quarter disc")
{
    const std::vector<ui::Point> corner = {{10.0, 50.0}, {10.0, 10.0}, {50.0, 10.0}};
    const double width = 8.0, legs = 80.0 * width, h = width / 2.0;
    const auto with = [&](ui::Join join) { return ink(stroked(corner, {.width = width, .join = join}), sheet); };
    // the legs overlap in a square of h by h inside and leave one open outside
    CHECK(with(ui::Join::Miter) == Approx(legs).epsilon(0.01));
    CHECK(with(ui::Join::Bevel) == Approx(legs - h * h / 2.0).epsilon(0.01));
    CHECK(with(ui::Join::Round) == Approx(legs - h * h * (1.0 - std::numbers::pi / 4.0)).epsilon(0.01));
}

TEST_CASE("No part of a curve of greater radius than the line is wide is covered twice")
{
    std::vector<ui::Point> wave;
    for (int i = 0; i <= 40; ++i) wave.push_back({5.0 + 1.25 * i, 30.0 + 4.0 * std::sin(0.3 * i)});
    ui::Mesh mesh = stroked(wave, {.width = 4.0, .join = ui::Join::Round});
    for (auto& vertex : mesh.vertices) vertex.coverage *= 0.5F; // twice covered would show as more than a half
    double darkest = 0.0;
    for (double y = 10.1; y < 50.0; y += 0.25)
        for (double x = 4.1; x < 56.0; x += 0.25) darkest = std::max(darkest, mesh.coverage_at({x, y}));
    CHECK(darkest == Approx(0.5).epsilon(0.02));
}

TEST_CASE("A closed line has no ends: its ink is its circumference times its width")
{
    const std::vector<ui::Point> triangle = {{10.0, 10.0}, {50.0, 15.0}, {20.0, 50.0}};
    double around = 0.0;
    for (std::size_t i = 0; i < 3; ++i) around += ui::distance(triangle[i], triangle[(i + 1) % 3]);
    const auto mesh = stroked(triangle, {.width = 2.0, .join = ui::Join::Miter}, ui::PathEnds::Closed);
    CHECK(ink(mesh, sheet) == Approx(2.0 * around).epsilon(0.02));
}

TEST_CASE("A line that turns straight back, repeats points or has no length stays finite")
{
    const std::vector<std::vector<ui::Point>> awkward = {{{10.0, 10.0}, {30.0, 10.0}, {12.0, 10.0}},
                                                         {{10.0, 10.0}, {10.0, 10.0}, {20.0, 20.0}, {20.0, 20.0}},
                                                         {{10.0, 10.0}, {10.0, 10.0}}};
    for (const auto& points : awkward) {
        for (const ui::Join join : {ui::Join::Miter, ui::Join::Round, ui::Join::Bevel}) {
            const auto mesh = stroked(points, {.width = 5.0, .cap = ui::Cap::Round, .join = join});
            for (const auto& v : mesh.vertices) {
                CHECK(std::isfinite(v.x));
                CHECK(std::isfinite(v.y));
            }
            CHECK(ink(mesh, sheet) > 0.0);
        }
    }
}

TEST_CASE("A filled polygon spends its area of ink, convex or not")
{
    CHECK(ink(filled({{10.0, 10.0}, {50.0, 14.0}, {30.0, 45.0}}), sheet) ==
          Approx(0.5 * (40.0 * 35.0 - 4.0 * 20.0)).epsilon(0.01));
    // an L of legs 10 wide
    CHECK(ink(filled({{10.0, 10.0}, {20.0, 10.0}, {20.0, 40.0}, {50.0, 40.0}, {50.0, 50.0}, {10.0, 50.0}}), sheet) ==
          Approx(40.0 * 10.0 + 30.0 * 10.0).epsilon(0.01));
}

TEST_CASE("A region with holes is filled once, and not in its holes, whichever way they run")
{
    const std::vector<ui::Point> outer = {{5.0, 5.0}, {55.0, 5.0}, {55.0, 55.0}, {5.0, 55.0}};
    std::vector<ui::Point> hole = {{20.0, 20.0}, {40.0, 20.0}, {40.0, 40.0}, {20.0, 40.0}}; // corners on the diagonals
    const std::vector<ui::Point> other = {{45.0, 10.0}, {50.0, 10.0}, {50.0, 16.0}};
    for (int i = 0; i < 2; ++i) {
        ui::Mesh mesh;
        ui::add_region(mesh, std::vector{outer, hole, other});
        CHECK(ink(mesh, sheet) == Approx(50.0 * 50.0 - 20.0 * 20.0 - 0.5 * 5.0 * 6.0).epsilon(0.01));
        CHECK(mesh.coverage_at({30.0, 30.0}) == 0.0);
        CHECK(mesh.coverage_at({48.5, 12.0}) == 0.0);
        CHECK(mesh.coverage_at({10.0, 30.0}) == Approx(1.0));
        std::reverse(hole.begin(), hole.end());
    }
}

namespace {

double area_of(const std::vector<ui::Trapezoid>& parts)
{
    double sum = 0.0;
    for (const auto& [top, bottom] : parts)
        sum += 0.5 * (top[1].x - top[0].x + bottom[1].x - bottom[0].x) * (bottom[0].y - top[0].y);
    return sum;
}

} // namespace

TEST_CASE("A map with ten thousand holes that touch at their corners is filled in as many trapezoids as it has corners")
{
    constexpr int n = 142; // cells of a row, turned a little so that no two corners are level
    const auto corner = [](int i, int j) { return ui::Point{5.0 * i + 0.031 * j, 4.0 * j - 0.017 * i}; };
    std::vector<std::vector<ui::Point>> loops{{corner(0, 0), corner(n, 0), corner(n, n), corner(0, n)}};
    for (int i = 0; i < n; ++i)
        for (int j = i % 2; j < n; j += 2)
            loops.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)});
    const double whole = 0.5 * std::abs(ui::twice_area(loops.front()));
    const std::vector<ui::Trapezoid> parts = ui::trapezoids(loops);
    CHECK(area_of(parts) == Approx(0.5 * whole));
    CHECK(parts.size() < 4 * loops.size());
}

TEST_CASE("Loops in loops are holes and islands by turns, and a loop that touches itself is filled once")
{
    const auto square = [](double a, double b) {
        return std::vector<ui::Point>{{a, a + 0.1}, {b, a}, {b - 0.1, b}, {a, b - 0.2}};
    };
    const std::vector<std::vector<ui::Point>> nest{square(2.0, 50.0), square(10.0, 40.0), square(20.0, 30.0)};
    const auto area = [](const std::vector<ui::Point>& loop) { return 0.5 * std::abs(ui::twice_area(loop)); };
    CHECK(area_of(ui::trapezoids(nest)) == Approx(area(nest[0]) - area(nest[1]) + area(nest[2])));
    const std::vector<std::vector<ui::Point>> glass{
        {{10.0, 10.0}, {30.0, 30.0}, {50.0, 10.0}, {50.0, 50.0}, {30.0, 30.0}, {10.0, 50.0}}};
    CHECK(area_of(ui::trapezoids(glass)) == Approx(0.5 * 40.0 * 40.0));
}

TEST_CASE("A hole as near to the outline as one likes is left out, and nothing is filled twice")
{
    const std::vector<ui::Point> outer = {{5.0, 5.0}, {55.0, 5.0}, {55.0, 30.0}, {5.0, 30.0}};
    for (const double gap : {0.3, 1e-2, 1e-3, 1e-4, 2e-5, 1e-6, 0.0}) {
        CAPTURE(gap);
        const double x = 5.0 + gap;
        const std::vector<std::vector<ui::Point>> loops{outer, {{x, 12.0}, {30.0, 12.0}, {30.0, 23.0}, {x, 23.0}}};
        ui::Mesh mesh;
        ui::add_region(mesh, loops);
        CHECK(ink(mesh, sheet) == Approx(50.0 * 25.0 - (30.0 - x) * 11.0).epsilon(0.01));
        CHECK(mesh.coverage_at({20.0, 16.0}) == 0.0);
        CHECK(mesh.coverage_at({10.0, 26.0}) == 1.0);
    }
}

TEST_CASE("A moment diagram that changes sign is filled on both sides of the member")
{
    const std::vector<ui::Point> bow_tie = {{10.0, 30.0}, {10.0, 10.0}, {50.0, 50.0}, {50.0, 30.0}};
    const auto loops = ui::simple_loops(bow_tie);
    REQUIRE(loops.size() == 2);
    CHECK(std::abs(ui::twice_area(loops[0])) == Approx(20.0 * 20.0));
    CHECK(std::abs(ui::twice_area(loops[1])) == Approx(20.0 * 20.0));
    CHECK(ink(filled(bow_tie), sheet) == Approx(20.0 * 20.0).epsilon(0.02));
}

TEST_CASE("A diagram that is zero along part of its member is filled only where it is not")
{
    struct Case {
        std::string claim;
        std::vector<ui::Point> outline;
        double area;
        std::vector<ui::Point> filled, bare;
    };
    const std::vector<Case> cases = {
        {"moment of a cantilever loaded at mid-span",
         {{10.0, 30.0}, {10.0, 10.0}, {30.0, 30.0}, {50.0, 30.0}},
         200.0,
         {{14.0, 20.0}, {12.0, 28.0}},
         {{34.0, 26.0}, {28.0, 24.0}, {40.0, 33.0}}},
        {"its shear force",
         {{10.0, 30.0}, {10.0, 12.0}, {31.0, 12.0}, {31.0, 30.0}, {51.0, 30.0}},
         21.0 * 18.0,
         {{12.0, 14.0}, {29.0, 14.0}, {29.0, 28.0}},
         {{34.0, 26.0}, {33.0, 20.0}, {45.0, 32.0}}},
        {"the same with the base line first",
         {{51.0, 30.0}, {10.0, 30.0}, {10.0, 12.0}, {31.0, 12.0}, {31.0, 30.0}},
         21.0 * 18.0,
         {{12.0, 14.0}, {29.0, 14.0}, {29.0, 28.0}},
         {{34.0, 26.0}, {33.0, 20.0}, {45.0, 32.0}}},
        {"shear force of a simple beam loaded at its thirds",
         {{5.0, 30.0}, {5.0, 12.0}, {20.0, 12.0}, {20.0, 30.0}, {39.0, 30.0}, {39.0, 51.0}, {55.0, 51.0}, {55.0, 30.0}},
         15.0 * 18.0 + 16.0 * 21.0,
         {{7.0, 14.0}, {18.0, 28.0}, {41.0, 32.0}, {53.0, 49.0}},
         {{24.0, 26.0}, {35.0, 34.0}, {30.0, 28.0}, {30.0, 32.0}}},
        {"zero at both ends, with a station on the base line and rounding off it",
         {{5.0, 30.0},
          {17.0, 30.0 - 3e-6},
          {21.0, 30.0 + 2e-6},
          {21.0, 9.0},
          {34.0, 9.0},
          {34.0, 30.0},
          {55.0, 30.0 + 1e-6}},
         13.0 * 21.0,
         {{23.0, 11.0}, {32.0, 28.0}},
         {{13.0, 28.0}, {19.0, 24.0}, {40.0, 26.0}, {45.0, 32.0}}},
        {"touching the base line at one point, on a slope",
         {{6.0, 8.0}, {16.0, 3.0}, {26.0, 18.0}, {36.0, 13.0}, {46.0, 28.0}},
         2.0 * 100.0,
         {{16.0, 8.0}, {36.0, 18.0}},
         {{26.0, 13.0}, {26.0, 21.0}}},
    };
    for (const Case& c : cases) {
        CAPTURE(c.claim);
        std::vector<ui::Point> backwards(c.outline.rbegin(), c.outline.rend());
        for (const auto& outline : {c.outline, backwards}) {
            const ui::Mesh mesh = filled(outline);
            CHECK(ink(mesh, sheet) == Approx(c.area).epsilon(0.02));
            for (const ui::Point p : c.filled) CHECK(mesh.coverage_at(p) == Approx(1.0));
            for (const ui::Point p : c.bare) CHECK(mesh.coverage_at(p) == Approx(0.0));
        }
    }
}

TEST_CASE("A triangulation has n - 2 triangles of the polygon's area in all")
{
    std::vector<ui::Point> star;
    for (int i = 0; i < 26; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 26.0, radius = i % 2 == 0 ? 25.0 : 9.0;
        star.push_back({30.0 + radius * std::cos(angle), 30.0 + radius * std::sin(angle)});
    }
    const auto triangles = ui::triangulation(star);
    CHECK(triangles.size() == star.size() - 2);
    double area = 0.0;
    for (const auto& t : triangles) area += std::abs(ui::twice_area(std::vector{star[t[0]], star[t[1]], star[t[2]]}));
    CHECK(area == Approx(std::abs(ui::twice_area(star))));
}

TEST_CASE("A triangulation covers nothing twice where corners of two flanges lie in one line")
{
    const std::vector<ui::Point> section{{0, 40}, {15, 40}, {15, 39}, {8, 39}, {8, 1},  {15, 1},
                                         {15, 0}, {0, 0},   {0, 1},   {7, 1},  {7, 39}, {0, 39}};
    for (std::size_t first = 0; first < section.size(); ++first) { // wherever it begins
        std::vector<ui::Point> turned = section;
        std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(first), turned.end());
        double area = 0.0;
        for (const auto& t : ui::triangulation(turned))
            area += std::abs(ui::twice_area(std::vector{turned[t[0]], turned[t[1]], turned[t[2]]}));
        CHECK(area == Approx(2.0 * (2.0 * 15.0 + 38.0)));
    }
}

TEST_CASE("Polygons without area or with repeated corners do no harm")
{
    CHECK(ink(filled({{10.0, 10.0}, {40.0, 10.0}, {25.0, 10.0}}), sheet) < 35.0); // at most its soft border
    CHECK(ink(filled({{10.0, 10.0}, {40.0, 10.0}, {40.0, 10.0}, {40.0, 40.0}, {10.0, 40.0}, {10.0, 10.0}}), sheet) ==
          Approx(900.0).epsilon(0.01));
    CHECK(filled({{10.0, 10.0}, {10.0, 10.0}, {10.0, 10.0}}).indices.empty());
}

TEST_CASE("A disc spends pi r^2 of ink")
{
    ui::Mesh mesh;
    ui::add_disc(mesh, {30.2, 29.6}, 11.0);
    CHECK(ink(mesh, sheet) == Approx(std::numbers::pi * 121.0).epsilon(0.01));
}

TEST_CASE("Dashes follow the pattern along the corner and begin where the offset says")
{
    const std::vector<ui::Point> corner = {{0.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}};
    const auto dashes = ui::dashes_of({corner, ui::PathEnds::Open, 0.0}, {8.0, 4.0});
    REQUIRE(dashes.size() == 2);
    CHECK(dashes[0].front() == ui::Point{0.0, 0.0});
    CHECK(dashes[0].back() == ui::Point{8.0, 0.0});
    CHECK(dashes[1].front() == ui::Point{10.0, 2.0});
    CHECK(dashes[1].back() == ui::Point{10.0, 10.0});

    const auto later = ui::dashes_of({corner, ui::PathEnds::Open, 10.0}, {8.0, 4.0}); // in a gap, 2 before its end
    REQUIRE(later.size() == 2);
    CHECK(later[0].front() == ui::Point{2.0, 0.0});
    CHECK(later[0].back() == ui::Point{10.0, 0.0});
    CHECK(later[1].front() == ui::Point{10.0, 4.0});
}

TEST_CASE("A dash that crosses a corner keeps the corner")
{
    const std::vector<ui::Point> corner = {{0.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}};
    const auto dashes = ui::dashes_of({corner, ui::PathEnds::Open, 0.0}, {15.0, 5.0});
    REQUIRE(dashes.size() == 1);
    CHECK(dashes[0] == std::vector<ui::Point>{{0.0, 0.0}, {10.0, 0.0}, {10.0, 5.0}});
}

TEST_CASE("A dash pattern that makes no sense is refused")
{
    CHECK_THROWS_AS((ui::DashPattern{4.0}), std::invalid_argument);
    CHECK_THROWS_AS((ui::DashPattern{0.0, 0.0}), std::invalid_argument);
    CHECK_THROWS_AS((ui::DashPattern{4.0, -1.0}), std::invalid_argument);
    CHECK_THROWS_AS((ui::DashPattern{1, 1, 1, 1, 1, 1, 1, 1}), std::invalid_argument);
    CHECK(ui::DashPattern{7.0, 3.0}.scaled(2.0) == ui::DashPattern{14.0, 6.0});
}

TEST_CASE("A straight diagram of forty stations becomes its two ends")
{
    std::vector<ui::Point> stations;
    for (int i = 0; i <= 40; ++i) stations.push_back({10.0 + 3.7 * i, 200.0 - 1.3 * i});
    CHECK(ui::simplified(stations, 0.05) == std::vector<ui::Point>{stations.front(), stations.back()});
}

TEST_CASE("A simplified curve keeps its corners and passes every point within the tolerance")
{
    const double tolerance = 0.06;
    std::vector<ui::Point> curve;
    for (int i = 0; i <= 200; ++i) {
        const double x = 2.0 * i, jump = i > 120 ? 35.0 : 0.0; // as at a point load
        curve.push_back({x, 80.0 * std::sin(0.02 * x) + jump});
    }
    const auto kept = ui::simplified(curve, tolerance);
    CHECK(kept.size() < curve.size() / 2);
    CHECK(std::count(kept.begin(), kept.end(), curve[120]) == 1);
    CHECK(std::count(kept.begin(), kept.end(), curve[121]) == 1);
    double farthest = 0.0;
    for (const ui::Point p : curve) {
        double nearest = 1e9;
        for (std::size_t k = 0; k + 1 < kept.size(); ++k) {
            const ui::Point d = kept[k + 1] - kept[k];
            const double t = std::clamp(ui::dot(p - kept[k], d) / ui::dot(d, d), 0.0, 1.0);
            nearest = std::min(nearest, ui::distance(p, kept[k] + t * d));
        }
        farthest = std::max(farthest, nearest);
    }
    CHECK(farthest <= tolerance);
}

TEST_CASE("A line that turns straight back keeps its turning point, and a loop its shape")
{
    const std::vector<ui::Point> back = {{0.0, 0.0}, {10.0, 0.0}, {20.0, 0.0}, {5.0, 0.0}};
    CHECK(ui::simplified(back, 0.1) == std::vector<ui::Point>{{0.0, 0.0}, {20.0, 0.0}, {5.0, 0.0}});
    const std::vector<ui::Point> square = {{0.0, 0.0}, {9.0, 0.0}, {9.0, 9.0}, {0.0, 9.0}, {0.0, 0.0}};
    CHECK(ui::simplified(square, 0.1) == square);
}

TEST_SUITE_END();
