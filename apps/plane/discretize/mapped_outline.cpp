#include "apps/plane/discretize/mapped_outline.h"

#include <algorithm>
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
            return refusal(FaultKind::MappedInside, {});
        std::array<std::size_t, 4> corners{};
        std::string missing;
        const std::size_t n_found = find_named(corners, missing);
        if (n_found < corners.size() && vertices_.size() == corners.size()) return sides(four_vertices());
        if (n_found == corners.size()) return follow(corners);
        if (settings_.corners.empty()) return refusal(FaultKind::MappedVertices, {std::to_string(vertices_.size())});
        return refusal(FaultKind::MappedCornerOff, {missing});
    }

private:
    MappedAttempt refusal(FaultKind kind, std::vector<std::string> details) const
    {
        details.insert(details.begin(), entry_of("regions", drawing_.model().regions, outline_.region.index));
        return {.sides = {}, .fault = femoop::Fault{kind, std::move(details)}};
    }

    bool meets_itself() const
    {
        std::vector<VertexId> sorted = vertices_;
        std::sort(sorted.begin(), sorted.end());
        return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
    }

    /// How many of the named corners are vertices of the outline, and which of these.
    std::size_t find_named(std::array<std::size_t, 4>& corners, std::string& missing) const
    {
        std::size_t n = 0;
        for (std::size_t i = 0; i < settings_.corners.size() && i < corners.size(); ++i) {
            const auto vertex = drawing_.vertex(settings_.corners[i]);
            const auto at = vertex ? std::find(vertices_.begin(), vertices_.end(), *vertex) : vertices_.end();
            if (at == vertices_.end()) missing = drawing_.model()[settings_.corners[i]].id;
            else corners[n++] = static_cast<std::size_t>(at - vertices_.begin());
        }
        return n;
    }

    /// Corners in the direction of the outline, whichever way they were listed; the first stays the first.
    MappedAttempt follow(std::array<std::size_t, 4> corners) const
    {
        const auto ahead = [&](std::size_t i) {
            return (corners[i] + vertices_.size() - corners[0]) % vertices_.size();
        };
        if (ahead(3) < ahead(1)) std::swap(corners[1], corners[3]);
        if (!(0 < ahead(1) && ahead(1) < ahead(2) && ahead(2) < ahead(3)))
            return refusal(FaultKind::MappedCornerOrder, {});
        return sides(corners);
    }

    /// From the one at the lower left.
    std::array<std::size_t, 4> four_vertices() const
    {
        const auto place = [&](std::size_t i) { return drawing_.subdivision().at(vertices_[i]); };
        std::size_t first = 0;
        for (std::size_t i = 1; i < vertices_.size(); ++i) {
            const double ahead = (place(i).x + place(i).y) - (place(first).x + place(first).y);
            if (ahead < 0.0 || (ahead == 0.0 && place(i).y < place(first).y)) first = i;
        }
        return {first, (first + 1) % 4, (first + 2) % 4, (first + 3) % 4};
    }

    MappedAttempt sides(const std::array<std::size_t, 4>& corners) const
    {
        MappedOutline found;
        for (std::size_t i = 0; i < corners.size(); ++i)
            for (std::size_t j = corners[i]; j != corners[(i + 1) % 4]; j = (j + 1) % loop_.size())
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
