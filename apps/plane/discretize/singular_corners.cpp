#include "apps/plane/discretize/singular_corners.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <utility>

namespace discretize {

std::vector<SingularCorner> singular_corners(const Drawing& drawing)
{
    constexpr double least = 185.0, whole_turn = 360.0 - 1e-6; // [degrees]
    const topology::PlanarSubdivision& plane = drawing.subdivision();
    const topology::Solid& solid = plane.solid();
    std::map<topology::VertexId, double> angles; // of all material about a vertex: regions that meet there add up
    for (const DrawnFace& face : drawing.faces()) {
        if (!face.region || drawing.model()[*face.region].is_hole) continue;
        for (const topology::LoopId loop : solid.loops(face.id))
            for (const topology::HalfEdgeId h : solid.chain(loop))
                if (solid.edge(h)) angles[solid.start(h)] += plane.corner_angle(h) * 180.0 / std::numbers::pi;
    }
    std::vector<SingularCorner> corners;
    for (const auto& [vertex, angle] : angles)
        if (angle > least && angle < whole_turn) corners.push_back({plane.at(vertex), angle});
    std::sort(corners.begin(), corners.end(), [](const SingularCorner& a, const SingularCorner& b) {
        return std::pair(a.at.x, a.at.y) < std::pair(b.at.x, b.at.y);
    });
    return corners;
}

} // namespace discretize
