#include "topology/geometry/predicates.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace topology;

namespace {

/// On whole numbers below 2^24 the determinant is exact in 128 bits.
__extension__ using Whole = __int128;

int sign(Whole value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }
int sign(double value) { return value > 0.0 ? 1 : value < 0.0 ? -1 : 0; }

struct WholePoint {
    long x, y;
    FlatPoint scaled(double by) const { return {by * static_cast<double>(x), by * static_cast<double>(y)}; }
};

Whole determinant(const WholePoint& a, const WholePoint& b, const WholePoint& c)
{
    return Whole(a.x - c.x) * (b.y - c.y) - Whole(a.y - c.y) * (b.x - c.x);
}

Whole determinant(const WholePoint& a, const WholePoint& b, const WholePoint& c, const WholePoint& d)
{
    const auto square = [&](const WholePoint& p) {
        return Whole(p.x - d.x) * (p.x - d.x) + Whole(p.y - d.y) * (p.y - d.y);
    };
    const auto cross = [&](const WholePoint& p, const WholePoint& q) {
        return Whole(p.x - d.x) * (q.y - d.y) - Whole(p.y - d.y) * (q.x - d.x);
    };
    return square(a) * cross(b, c) + square(b) * cross(c, a) + square(c) * cross(a, b);
}

} // namespace

TEST_SUITE("exact predicates")
{
    TEST_CASE("Side and circle have the sign of whole numbers' determinants, however near in line or on one circle")
    {
        std::mt19937 random(7);
        constexpr long reach = 1 << 20;
        std::uniform_int_distribution<long> any(-reach, reach), near(-2, 2);
        for (int i = 0; i < 20000; ++i) {
            const WholePoint a{any(random), any(random)}, b{any(random), any(random)};
            // the far end of a line that runs once more as far, and the opposite corner of a rectangle: then a bit beside
            const WholePoint line{2 * b.x - a.x + near(random), 2 * b.y - a.y + near(random)};
            const WholePoint c{a.x - (b.y - a.y), a.y + (b.x - a.x)};
            const WholePoint d{b.x + c.x - a.x + near(random), b.y + c.y - a.y + near(random)};
            CAPTURE(i);
            for (const double scale : {1.0, 0x1p-40}) {
                CHECK(sign(orientation(a.scaled(scale), b.scaled(scale), line.scaled(scale))) ==
                      sign(determinant(a, b, line)));
                CHECK(sign(in_circle(a.scaled(scale), b.scaled(scale), c.scaled(scale), d.scaled(scale))) ==
                      sign(determinant(a, b, c, d)));
            }
        }
    }

    TEST_CASE("A place one rounding off a line lies off it, where plain arithmetic says that it is on it")
    {
        const FlatPoint a{0.5, 0.5}, b{12.0, 12.0};
        const FlatPoint beside{24.0, std::nextafter(24.0, 25.0)};
        CHECK(orientation(a, b, {24.0, 24.0}) == 0.0);
        CHECK(orientation(a, b, beside) > 0.0);
        CHECK(orientation(b, a, beside) < 0.0);
    }

    TEST_CASE("A circumcentre is as far from all three places")
    {
        const FlatPoint a{3.0, 1.0}, b{7.0, -2.0}, c{4.5, 6.0}, centre = circumcentre(a, b, c);
        CHECK(distance(centre, a) == doctest::Approx(distance(centre, b)).epsilon(1e-14));
        CHECK(distance(centre, a) == doctest::Approx(distance(centre, c)).epsilon(1e-14));
    }
}
