#include "femoop/plane/mesh/locator.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "femoop/io/plane/plane_file.h"
#include "tests/femoop/plane/plane_text.h"

using namespace femoop;
using namespace femoop::plane;

namespace {

/// Triangles about the origin, corners on a circle of radius 2.
PlaneModel fan(std::size_t n)
{
    PlaneModel model;
    model.materials.push_back({.id = "m", .E = 3.0, .nu = 0.3});
    model.regions.push_back({.id = "disc", .material = MaterialId(0), .thickness = 0.7});
    model.points.push_back({.id = "O", .at = {0.0, 0.0}});
    for (std::size_t i = 0; i < n; ++i) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
        model.points.push_back({.id = std::to_string(i), .at = {2.0 * std::cos(angle), 2.0 * std::sin(angle)}});
        model.elements.push_back({.id = std::to_string(i),
                                  .kind = ShapeKind::T3,
                                  .points = {NodeId(0), NodeId(i + 1), NodeId((i + 1) % n + 1)},
                                  .region = RegionId(0)});
    }
    return model;
}

} // namespace

TEST_CASE("Beside a straight side there is nothing, on it and within there is the element")
{
    const PlaneModel model = read_plane_model(PlaneText{}.text());
    const Locator locator(model);
    CHECK(locator.find({5.0, 1.999}).size() == 1);
    CHECK(locator.find({5.0, 2.0}).size() == 1);
    CHECK(locator.find({3.0, 2.0}).size() == 2);
    for (const Eigen::Vector2d& at : {Eigen::Vector2d(5.0, 2.001), Eigen::Vector2d(5.0, -0.05),
                                      Eigen::Vector2d(-0.01, 1.0), Eigen::Vector2d(7.001, 2.001)})
        CHECK(locator.find(at).empty());
}

TEST_CASE("Places of a circle belong to the elements whose sides are its chords; at corners there are none")
{
    for (const std::size_t n : {7U, 12U, 40U}) {
        CAPTURE(n);
        const PlaneModel model = fan(n);
        const Locator locator(model);
        for (int i = 0; i < 97; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / 97.0;
            CHECK_FALSE(locator.find({1.9999 * std::cos(angle), 1.9999 * std::sin(angle)}).empty());
        }
        CHECK(locator.find({2.5, 0.0}).empty());
    }
    const PlaneModel square = fan(4);
    CHECK(Locator(square).find({1.02, 1.02}).empty());
    CHECK(Locator(square).find({0.99, 0.99}).size() == 1);
}
