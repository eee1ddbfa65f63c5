// Principal stress trajectories.
#include <doctest/doctest.h>

#include <cmath>

#include "femoop/plane/result/trajectories.h"
#include "tests/femoop/plane/result/plane_case.h"

using namespace femoop::plane;
using Eigen::Vector2d;

namespace {

/// The sine of the angle between a piece of a trajectory and the principal direction at its middle.
double deviation(const PlaneResults& results, const PlaneCase& result, const Vector2d& a, const Vector2d& b,
                 PrincipalFamily family)
{
    const auto places = results.locator().find(0.5 * (a + b));
    const PrincipalStress s = principal(result.smoothed_stress(places.front()));
    Vector2d d(std::cos(s.angle), std::sin(s.angle));
    if (family == PrincipalFamily::Second) d = Vector2d(-d.y(), d.x());
    const Vector2d along = (b - a).normalized();
    return std::abs(along.x() * d.y() - along.y() * d.x());
}

double distance_to(const std::vector<Trajectory>& lines, const Vector2d& at)
{
    double least = 1e30;
    for (const Trajectory& line : lines)
        for (const Vector2d& p : line) least = std::min(least, (p - at).norm());
    return least;
}

} // namespace

TEST_CASE("In a uniform state trajectories are straight lines along the principal direction")
{
    const PlaneResults results = plane_test::solved("CO-001-a"); // sx = sy = 1333, txy = 400: 45 degrees
    const PlaneCase result = results[femoop::CaseId{}];
    for (const PrincipalFamily family : {PrincipalFamily::First, PrincipalFamily::Second}) {
        const auto lines = trajectories(results, result, family, 0.02);
        CHECK(lines.size() > 5);
        const double turn = family == PrincipalFamily::First ? 1.0 : -1.0;
        for (const Trajectory& line : lines)
            for (std::size_t i = 1; i < line.size(); ++i) {
                const Vector2d along = line[i] - line[i - 1];
                CHECK(along.y() == doctest::Approx(turn * along.x()).epsilon(1e-6));
            }
    }
}

TEST_CASE("Trajectories of a cantilever run along the principal directions, apart from one another, and cover it")
{
    const PlaneResults results = analyse(read_plane_model(plane_test::cantilever_text(10, 4)));
    const PlaneCase result = results[femoop::CaseId{}];
    constexpr double spacing = 0.3;
    for (const PrincipalFamily family : {PrincipalFamily::First, PrincipalFamily::Second}) {
        const auto lines = trajectories(results, result, family, spacing);
        CHECK(lines.size() > 8);
        for (std::size_t k = 0; k < lines.size(); ++k) {
            for (std::size_t i = 1; i < lines[k].size(); ++i)
                if ((lines[k][i] - lines[k][i - 1]).norm() > 0.05 * spacing)
                    CHECK(deviation(results, result, lines[k][i - 1], lines[k][i], family) < 0.05);
            std::vector<Trajectory> others = lines;
            others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
            // the last piece to the border may come a little closer
            for (std::size_t i = 1; i + 1 < lines[k].size(); ++i)
                CHECK(distance_to(others, lines[k][i]) > 0.4 * spacing);
        }
        for (double x = 0.5; x < 9.5; x += 0.7)
            for (double y = -0.8; y < 0.9; y += 0.4) {
                CAPTURE(x);
                CAPTURE(y);
                CHECK(distance_to(lines, {x, y}) < 1.5 * spacing);
            }
    }
}
