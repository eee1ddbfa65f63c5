// Lines and areas of equal value of a field on triangles.
#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <vector>

#include "femoop/plane/result/iso_areas.h"
#include "femoop/plane/result/round_levels.h"

using namespace femoop::plane;
using Eigen::Vector2d;

namespace {

/// A rectangle of n x m cells of two triangles each, a field over it.
template <class Value> TriangulatedField grid(int n, int m, const Vector2d& size, const Value& value)
{
    TriangulatedField field;
    for (int j = 0; j <= m; ++j)
        for (int i = 0; i <= n; ++i) field.places.emplace_back(size.x() * i / n, size.y() * j / m);
    const auto add = [&](std::array<std::uint32_t, 3> corners) {
        field.triangles.push_back(corners);
        auto& values = field.values.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) values[k] = value(field.places[corners[k]], field.triangles.size() - 1);
    };
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i) {
            const auto a = static_cast<std::uint32_t>(j * (n + 1) + i), b = a + 1,
                       c = b + static_cast<std::uint32_t>(n + 1), d = c - 1;
            add({a, b, c});
            add({a, c, d});
        }
    join(field);
    return field;
}

double area_of(const std::vector<IsoLoop>& loops)
{
    double sum = 0.0;
    for (const IsoLoop& loop : loops) sum += area(loop);
    return sum;
}

constexpr double width = 5.0, height = 3.0;

} // namespace

TEST_CASE("Lines of a linear field are straight, run from border to border, and lie at equal distances")
{
    const Vector2d slope(0.7, 1.9);
    const auto field = grid(7, 11, {width, height}, [&](const Vector2d& at, std::size_t) { return slope.dot(at); });
    for (const double level : {1.1, 2.2, 3.3, 4.4}) {
        CAPTURE(level);
        const auto lines = iso_lines(field, level);
        REQUIRE(lines.size() == 1);
        for (const Vector2d& at : lines[0]) CHECK(slope.dot(at) == doctest::Approx(level));
        const auto is_on_border = [](const Vector2d& at) {
            return std::min({at.x(), at.y(), width - at.x(), height - at.y()}) < 1e-12;
        };
        CHECK(is_on_border(lines[0].front()));
        CHECK(is_on_border(lines[0].back()));
        const Vector2d along = lines[0].back() - lines[0].front();
        CHECK(along.x() * slope.y() - along.y() * slope.x() > 0.0); // larger values lie to the left
    }
}

TEST_CASE("What lies above a level of a linear field has the area of the polygon that a line cuts off")
{
    const auto field = grid(6, 4, {width, height},
                            [](const Vector2d& at, std::size_t) { return at.x() + 2.0 * at.y(); });
    constexpr double level = 2.5; // the triangle below it has the legs 2.5 and 1.25
    CHECK(area_of(loops_above(field, level)) == doctest::Approx(width * height - 0.5 * level * 0.5 * level));
    CHECK(loops_above(field, level).size() == 1);
}

TEST_CASE("Areas of bands sum to the area of the mesh, holes counted as such")
{
    const auto field = grid(40, 30, {width, height}, [](const Vector2d& at, std::size_t) {
        return std::sin(2.9 * at.x()) * std::cos(3.7 * at.y()) + 0.1 * at.x();
    });
    const std::vector<double> levels = round_levels(-1.0, 1.5);
    double sum = 0.0, above = area_of(loops_above(field, levels.front()));
    CHECK(above == doctest::Approx(field.area()));
    for (std::size_t i = 1; i < levels.size(); ++i) {
        const double next = area_of(loops_above(field, levels[i]));
        CHECK(next <= above * (1.0 + 1e-12));
        sum += above - next;
        above = next;
    }
    CHECK(above == doctest::Approx(0.0).epsilon(1e-12));
    CHECK(sum == doctest::Approx(width * height));
}

TEST_CASE("A valley is a hole of what lies above, of the area of its circle")
{
    const Vector2d middle(2.4, 1.6);
    constexpr double r = 1.1;
    const auto field = grid(160, 100, {width, height},
                            [&](const Vector2d& at, std::size_t) { return (at - middle).squaredNorm(); });
    const std::vector<IsoArea> areas = areas_above(field, r * r);
    REQUIRE(areas.size() == 1);
    REQUIRE(areas[0].holes.size() == 1);
    CHECK(area(areas[0].outside) == doctest::Approx(width * height));
    CHECK(area(areas[0].holes[0]) == doctest::Approx(-std::numbers::pi * r * r).epsilon(1e-3));
    const auto lines = iso_lines(field, r * r);
    REQUIRE(lines.size() == 1);
    CHECK(lines[0].front() == lines[0].back());
}

TEST_CASE("A level that corners have exactly, and a plateau, lose no area and repeat none")
{
    const auto field = grid(9, 6, {width, height}, [](const Vector2d& at, std::size_t) {
        return std::round(3.0 * std::sin(at.x())) + std::round(at.y());
    });
    double sum = 0.0, above = area_of(loops_above(field, -3.0));
    for (double level = -2.0; level < 9.0; level += 1.0) {
        CAPTURE(level);
        const double next = area_of(loops_above(field, level));
        CHECK(next <= above + 1e-12);
        CHECK(next >= -1e-12);
        sum += above - next;
        above = next;
    }
    CHECK(sum == doctest::Approx(width * height));
}

TEST_CASE("Where a field jumps from cell to cell, what is above the level on both sides is one area")
{
    // each triangle has a constant of its own: those of the left half are above
    const auto field = grid(8, 3, {width, height}, [](const Vector2d&, std::size_t t) {
        return (t / 2) % 8 < 4 ? 5.0 + static_cast<double>(t % 7) : -1.0;
    });
    const auto areas = areas_above(field, 2.0);
    REQUIRE(areas.size() == 1);
    CHECK(areas[0].holes.empty());
    CHECK(area(areas[0].outside) == doctest::Approx(0.5 * width * height));
    CHECK(iso_lines(field, 2.0).empty());
}

TEST_CASE("A field that jumps and slopes keeps the area of what is above in every triangle")
{
    const auto value = [](const Vector2d& at, std::size_t t) {
        return at.x() + 0.4 * static_cast<double>(t % 5) - 0.7 * at.y() * static_cast<double>(t % 3);
    };
    const auto field = grid(6, 5, {width, height}, value);
    for (const double level : {0.3, 1.0, 2.7}) {
        CAPTURE(level);
        double sum = 0.0;
        for (std::size_t t = 0; t < field.triangles.size(); ++t) { // each by itself
            TriangulatedField one{field.places, {field.triangles[t]}, {field.values[t]}, {}, {}, {}};
            join(one);
            sum += area_of(loops_above(one, level));
        }
        CHECK(area_of(loops_above(field, level)) == doctest::Approx(sum));
    }
}

TEST_CASE("Levels are round, and enclose the range")
{
    CHECK(round_levels(-37.0, 151.0).front() == doctest::Approx(-40.0));
    CHECK(round_levels(-37.0, 151.0).back() == doctest::Approx(160.0));
    CHECK(round_levels(-37.0, 151.0)[1] == doctest::Approx(-20.0));
    for (const double high : {0.0173, 3.0, 999.0}) {
        CAPTURE(high);
        const auto levels = round_levels(0.3 * high, high);
        CHECK(levels.front() <= 0.3 * high * (1.0 + 1e-9));
        CHECK(levels.back() >= high * (1.0 - 1e-9));
        CHECK(levels.size() >= 7);
        CHECK(levels.size() <= 13);
    }
    CHECK(round_levels(4.0, 4.0).size() == 2);
    for (const double high : {0.0, 5e-324, 1e-310, 1e-300, 1e300}) {
        CAPTURE(high);
        for (const double low : {-high, 0.0, high}) {
            const auto levels = round_levels(low, high);
            CHECK(levels.size() >= 2);
            CHECK(levels.size() <= 13);
            CHECK(std::ranges::is_sorted(levels));
        }
    }
    CHECK(round_levels(-1.7e308, 1.7e308) == std::vector{-1.7e308, 0.0, 1.7e308});
}

TEST_CASE("Ten bands of 200 000 triangles are built in well under a second")
{
    const auto field = grid(400, 250, {width, height}, [](const Vector2d& at, std::size_t) {
        return std::sin(1.9 * at.x()) * std::cos(2.7 * at.y());
    });
    const auto made = std::chrono::steady_clock::now();
    std::size_t n = 0;
    for (const double level : round_levels(-1.0, 1.0)) n += areas_above(field, level).size();
    const auto end = std::chrono::steady_clock::now();
    const auto ms = [](auto d) { return std::chrono::duration<double, std::milli>(d).count(); };
    CHECK(n > 11);
    CHECK(ms(end - made) < 1000.0);
}
