#include "apps/plane/discretize/mapped_outline.h"

#include <algorithm>
#include <numbers>
#include <string>
#include <utility>

#include "apps/plane/discretize/entry_name.h"

namespace discretize {

namespace {

using femoop::FaultKind;
using topology::VertexId;

class CornerSearch {
public:
    CornerSearch(const Drawing& drawing, const FaceOutline& outline, const MeshSettings& settings)
        : drawing_(drawing), outline_(outline), settings_(settings), loop_(outline.loops.front())
    {
        for (const topology::HalfEdgeId h : loop_) vertices_.push_back(drawing.subdivision().solid().start(h));
    }

    MappedAttempt run() const
    {
        if (outline_.loops.size() > 1 || !outline_.inner_edges.empty() || !outline_.inner_vertices.empty() ||
            meets_itself())
            return refusal(FaultKind::MappedInside, {method()});
        std::string missing;
        const Corners corners = named(missing);
        const std::size_t n_wanted = settings_.n_corners();
        const bool are_all = vertices_.size() == n_wanted && (settings_.is_map() || turns_at_all());
        if (corners.size() < n_wanted && are_all && !are_corners_its_own()) return sides(all_vertices());
        if (settings_.corners.empty())
            return refusal(FaultKind::MappedVertices,
                           {method(), std::to_string(n_wanted), std::to_string(vertices_.size())});
        if (settings_.corners.size() != n_wanted)
            return refusal(FaultKind::CornerCount, {std::to_string(settings_.corners.size())});
        return corners.size() == n_wanted ? follow(corners) : refusal(FaultKind::MappedCornerOff, {missing});
    }

private:
    using Corners = std::vector<std::size_t>; ///< places in the outline

    MappedAttempt refusal(FaultKind kind, std::vector<std::string> details) const
    {
        details.insert(details.begin(), entry_of("regions", drawing_.model().regions, outline_.region.index));
        return {.sides = {}, .fault = femoop::Fault{kind, std::move(details)}};
    }

    /// Named for this region: by itself, or by a file that has no other.
    bool are_corners_its_own() const
    {
        const auto& regions = drawing_.model().regions;
        const auto n_filled = std::count_if(regions.begin(), regions.end(),
                                            [](const auto& one) { return !one.is_hole; });
        return !settings_.corners.empty() && (n_filled == 1 || !drawing_.model()[outline_.region].mesh.corners.empty());
    }

    bool meets_itself() const
    {
        std::vector<VertexId> sorted = vertices_;
        std::sort(sorted.begin(), sorted.end());
        return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
    }

    /// A joint where curves touch is no corner.
    bool turns_at_all() const
    {
        constexpr double straight = 160.0 / 180.0 * std::numbers::pi;
        return std::all_of(loop_.begin(), loop_.end(),
                           [&](topology::HalfEdgeId h) { return drawing_.subdivision().corner_angle(h) < straight; });
    }

    std::string method() const { return settings_.is_map() ? settings_.method : "mapped"; }

    /// Those of the named corners that are vertices of the outline.
    Corners named(std::string& missing) const
    {
        Corners corners;
        for (const femoop::NodeId corner : settings_.corners) {
            const auto vertex = drawing_.vertex(corner);
            const auto at = vertex ? std::find(vertices_.begin(), vertices_.end(), *vertex) : vertices_.end();
            if (at == vertices_.end()) missing = drawing_.model()[corner].id;
            else corners.push_back(static_cast<std::size_t>(at - vertices_.begin()));
        }
        return corners;
    }

    /// Corners in the direction of the outline, whichever way they were listed; the first stays the first.
    MappedAttempt follow(Corners corners) const
    {
        const auto ahead = [&](std::size_t i) {
            return (corners[i] + vertices_.size() - corners[0]) % vertices_.size();
        };
        if (ahead(corners.size() - 1) < ahead(1)) std::reverse(corners.begin() + 1, corners.end());
        for (std::size_t i = 1; i < corners.size(); ++i)
            if (ahead(i) <= ahead(i - 1)) return refusal(FaultKind::MappedCornerOrder, {});
        return sides(corners);
    }

    /// From the one at the lower left.
    Corners all_vertices() const
    {
        const auto place = [&](std::size_t i) { return drawing_.subdivision().at(vertices_[i]); };
        std::size_t first = 0;
        for (std::size_t i = 1; i < vertices_.size(); ++i) {
            const double ahead = (place(i).x + place(i).y) - (place(first).x + place(first).y);
            if (ahead < 0.0 || (ahead == 0.0 && place(i).y < place(first).y)) first = i;
        }
        Corners corners;
        for (std::size_t i = 0; i < vertices_.size(); ++i) corners.push_back((first + i) % vertices_.size());
        return corners;
    }

    MappedAttempt sides(const Corners& corners) const
    {
        MappedOutline found(corners.size());
        for (std::size_t i = 0; i < corners.size(); ++i)
            for (std::size_t j = corners[i]; j != corners[(i + 1) % corners.size()]; j = (j + 1) % loop_.size())
                found[i].push_back(loop_[j]);
        return {.sides = std::move(found), .fault = {}};
    }

    const Drawing& drawing_;
    const FaceOutline& outline_;
    const MeshSettings& settings_;
    const OutlineLoop& loop_;
    std::vector<VertexId> vertices_;
};

} // namespace

MappedAttempt mapped_outline(const Drawing& drawing, const FaceOutline& outline, const MeshSettings& settings)
{
    return CornerSearch(drawing, outline, settings).run();
}

} // namespace discretize
