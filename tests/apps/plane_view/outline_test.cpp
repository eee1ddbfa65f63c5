// The outline of a plane model as straight lines.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "apps/plane/view/plate_outline.h"
#include "tests/apps/plane_view/plate_subject.h"

using namespace plane;

namespace {

double area_of(const PlaceLine& loop)
{
    double twice = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Eigen::Vector2d &a = loop[i], &b = loop[(i + 1) % loop.size()];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return 0.5 * twice;
}

double area_of(const OutlinedFace& face)
{
    double sum = 0.0;
    for (const PlaceLine& loop : face.loops) sum += area_of(loop);
    return sum;
}

const char* const ring_text = R"({"cremona": 1, "analysis": "plane_stress", "units": {"length": "m", "force": "kN"},
 "materials": [{"id": "m", "E": 7, "nu": 0.3}],
 "points": [{"id": "O", "at": [3, 2]}],
 "curves": [{"id": "outer", "kind": "circle", "center": "O", "radius": 5},
            {"id": "inner", "kind": "circle", "center": "O", "radius": 2}],
 "regions": [{"id": "ring", "at": [6.5, 2], "material": "m", "thickness": 0.5},
             {"id": "hole", "at": [3.5, 2.5], "hole": true}]})";

} // namespace

TEST_CASE("The outline of a ring strays from its circles by no more than was asked, and its area is that of the ring")
{
    const PlateSubject ring(ring_text);
    constexpr double tolerance = 1e-3, R = 5.0, r = 2.0;
    const PlateOutline outline = outline_of(*ring.input().drawing, tolerance);
    REQUIRE(outline.faces.size() == 2);
    for (const OutlinedFace& face : outline.faces) {
        CAPTURE(face.is_hole);
        const double exact = std::numbers::pi * (face.is_hole ? r * r : R * R - r * r);
        CHECK(std::abs(area_of(face) - exact) < 2.0 * std::numbers::pi * (R + r) * tolerance);
        CHECK(face.loops.size() == (face.is_hole ? 1u : 2u));
    }
    for (const OutlinedPiece& piece : outline.pieces)
        for (std::size_t i = 1; i < piece.line.size(); ++i) {
            const Eigen::Vector2d middle = 0.5 * (piece.line[i] + piece.line[i - 1]);
            const double from_center = (middle - Eigen::Vector2d(3.0, 2.0)).norm();
            CHECK(std::min(std::abs(from_center - R), std::abs(from_center - r)) < tolerance);
        }
}

TEST_CASE("Outward of a ring's circles leads away from the material")
{
    const PlateSubject ring(ring_text);
    const PlateOutline outline = outline_of(*ring.input().drawing, 0.01);
    for (const std::size_t curve : {0u, 1u}) {
        const auto paths = paths_of(outline, femoop::plane::CurveId(curve));
        REQUIRE(paths.size() == 1);
        const Eigen::Vector2d radial = paths[0].line[0] - Eigen::Vector2d(3.0, 2.0);
        CHECK(paths[0].outward(0).dot(radial) * (curve == 0 ? 1.0 : -1.0) > 0.0);
        CHECK(paths[0].s.back() == doctest::Approx(2.0 * std::numbers::pi * (curve == 0 ? 5.0 : 2.0)).epsilon(0.01));
    }
}

TEST_CASE("A mesh's regions end where their elements have no neighbour, holes included")
{
    // 3 x 3 squares without the one in the middle
    std::string points, elements;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i)
            points += std::string(points.empty() ? "" : ",") + "{\"id\": \"" + std::to_string(4 * j + i) +
                      "\", \"at\": [" + std::to_string(2 * i) + ", " + std::to_string(3 * j) + "]}";
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) {
            if (i == 1 && j == 1) continue;
            const auto id = [&](int k) { return "\"" + std::to_string(k) + "\""; };
            const int at = 4 * j + i;
            elements += std::string(elements.empty() ? "" : ",") + "{\"id\": " + id(at) +
                        ", \"kind\": \"Q4\", \"region\": \"r\", \"points\": [" + id(at) + "," + id(at + 1) + "," +
                        id(at + 5) + "," + id(at + 4) + "]}";
        }
    const PlateSubject frame(
        R"({"cremona": 1, "analysis": "plane_stress", "units": {"length": "m", "force": "kN"}, "materials": [{"id": "m", "E": 7, "nu": 0.3}],
      "regions": [{"id": "r", "material": "m", "thickness": 0.5}], "points": [)" +
        points + "], \"elements\": [" + elements + "]}");
    const PlateOutline outline = outline_of(frame.model(), 0.01);
    REQUIRE(outline.faces.size() == 1);
    CHECK(outline.faces[0].loops.size() == 2);
    CHECK(area_of(outline.faces[0]) == doctest::Approx(8.0 * 2.0 * 3.0));
    CHECK(outline.pieces.size() == 16);
}
