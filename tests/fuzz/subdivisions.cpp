// Whatever curves are put into a subdivision, in whatever order they are taken back: it stays a sound solid with
// V - E + F = 1 + C, each face that is not thin has a place inside it, one that is refused leaves nothing behind, and undo
// is exact.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "tests/fuzz/bytes.h"
#include "topology/halfedge/check/validate.h"
#include "topology/planar/planar_subdivision.h"

namespace {

using namespace topology;
using fuzz::Bytes;
using fuzz::place;

constexpr double snap = 1e-9;
constexpr std::size_t most_curves = 16;

[[noreturn]] void fail(const std::string& what)
{
    std::cerr << what << '\n';
    std::abort();
}

double turns(std::uint8_t byte) { return 2.0 * std::numbers::pi * byte / 256.0; }

EllipticArc arc(Bytes& bytes, bool is_whole)
{
    const FlatPoint center = place(bytes);
    const double a = (1 + bytes.next()) / 256.0, b = is_whole ? a : (1 + bytes.next()) / 256.0;
    const double tilt = is_whole ? 0.0 : turns(bytes.next());
    const double c = std::cos(tilt), s = std::sin(tilt);
    EllipticArc made{center, {a * c, a * s}, {-b * s, b * c}, 0.0, 2.0 * std::numbers::pi};
    if (is_whole) return made;
    made.start = turns(bytes.next());
    const std::uint8_t sweep = bytes.next();
    made.sweep = sweep % 2 == 0 ? turns(sweep) : -turns(sweep);
    return made;
}

bool are_in_line(const std::array<FlatPoint, 4>& points)
{
    double most = 0.0;
    for (const FlatPoint& a : points)
        for (const FlatPoint& b : points) most = std::max(most, std::abs(cross(a - points[0], b - points[0])));
    return most < 4.0 * snap;
}

/// Nothing: one that would run back along itself.
std::optional<Curve> curve(Bytes& bytes, std::uint8_t kind)
{
    if (kind == 0) return arc(bytes, true);
    if (kind == 1) return arc(bytes, false);
    const FlatPoint a = place(bytes), b = place(bytes);
    if (kind != 2) return Segment{a, b};
    const CubicBezier cubic{{a, b, place(bytes), place(bytes)}};
    return are_in_line(cubic.points) ? std::nullopt : std::optional<Curve>(cubic);
}

void require_sound(const PlanarSubdivision& plane)
{
    if (const auto breach = why_not_valid(plane.solid())) fail(sentence(*breach));
    const PlanarCounts counts = plane.counts();
    if (counts.vertices + counts.regions != counts.edges + counts.components) fail("V - E + F is not 1 + C");
    for (const FaceId f : plane.solid().faces()) {
        const bool is_thin = plane.area(f) < 1e4 * snap * plane.perimeter(f); // a place in it is on its edges
        if (f == plane.unbounded() || is_thin) continue;
        if (plane.face_at(plane.place_inside(f)) != f) fail("the place inside a face is in another");
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    Bytes bytes(data, size);
    PlanarSubdivision plane(snap);
    std::vector<Solid> before;
    const auto undo = [&] {
        plane.undo();
        if (!(plane.solid() == before.back())) fail("undo left something behind");
        before.pop_back();
    };
    for (std::size_t i = 0; i < most_curves && bytes.left() > 0; ++i) {
        const std::uint8_t kind = bytes.next() % 8;
        if (kind == 7 && !before.empty()) {
            undo();
            continue;
        }
        before.push_back(plane.solid());
        if (kind == 6) {
            plane.insert(place(bytes));
        } else {
            const std::optional<Curve> drawn = curve(bytes, kind);
            const bool is_drawn = drawn && drawn->length({}) > 2.0 * snap &&
                                  !plane.insert(*drawn, {drawn->at(0.0), drawn->at(1.0)});
            if (!is_drawn) {
                if (!(plane.solid() == before.back())) fail("a curve that is refused left something behind");
                before.pop_back();
            }
        }
        require_sound(plane);
    }
    while (!before.empty()) undo();
    return 0;
}
