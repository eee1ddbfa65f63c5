#include "apps/plane/discretize/merged_places.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "apps/plane/discretize/entry_name.h"

namespace discretize {

namespace {

using femoop::NodeId;
using femoop::plane::CurveId;
using topology::FlatPoint;
using topology::HalfEdgeId;
using topology::PlanarSubdivision;
using topology::VertexId;

constexpr double round_off = 1e-11; // of the drawing's diagonal; a hundredth of the usual snap

/// What has become one vertex.
struct Gathering {
    std::set<std::size_t> points, curves; ///< of the model
    double apart = 0.0;                   ///< how far from the vertex, at most
};

/// Gathers what meets at each vertex.
class MergeSearch {
public:
    explicit MergeSearch(const Drawing& drawing)
        : drawing_(drawing), model_(drawing.model()), plane_(drawing.subdivision())
    {
        for (std::size_t i = 0; i < model_.points.size(); ++i)
            if (const auto vertex = drawing.vertex(NodeId(i))) points_[*vertex].push_back(i);
    }

    std::vector<femoop::Fault> run()
    {
        topology::FlatBox box;
        for (const VertexId v : plane_.solid().vertices()) box.add(plane_.at(v));
        const double least = std::min(round_off * box.diagonal(), 0.01 * plane_.snap());
        std::vector<femoop::Fault> found;
        for (const VertexId v : plane_.solid().vertices()) {
            const Gathering here = gathered_at(v);
            if (here.apart > least || here.points.size() > 1) found.push_back(warning(v, here));
        }
        return found;
    }

private:
    Gathering gathered_at(VertexId v) const
    {
        Gathering here;
        if (const auto points = points_.find(v); points != points_.end())
            for (const std::size_t i : points->second) {
                here.points.insert(i);
                see(here, v, {model_.points[i].at[0], model_.points[i].at[1]});
            }
        for (const HalfEdgeId h : plane_.solid().fan(v)) {
            const auto e = plane_.solid().edge(h);
            if (!e) continue; // a vertex alone
            for (const topology::CurvePart& part : plane_.carriers(*e)) {
                here.curves.insert(drawing_.owner(part.curve).index);
                const double t = h == plane_.solid().plus(*e) ? part.span.from : part.span.to;
                see(here, v, place_on(part.curve, t, plane_.at(v)));
            }
        }
        return here;
    }

    /// Of a curve beside a vertex: its end as it was drawn, or what is nearest.
    FlatPoint place_on(topology::CurveIndex i, double t, const FlatPoint& vertex) const
    {
        if (t == 0.0) return drawing_.ends(i)[0];
        if (t == 1.0) return drawing_.ends(i)[1];
        const topology::Curve& curve = plane_.curve(i);
        return curve.at(curve.nearest(vertex));
    }

    void see(Gathering& here, VertexId v, const FlatPoint& place) const
    {
        here.apart = std::max(here.apart, distance(plane_.at(v), place));
    }

    femoop::Fault warning(VertexId v, const Gathering& here) const
    {
        std::vector<std::string> entries, names;
        for (const std::size_t i : here.points) {
            entries.push_back(entry_of("points", model_.points, i));
            names.push_back(model_.points[i].id);
        }
        for (const std::size_t i : here.curves) {
            entries.push_back(entry_of("curves", model_.curves, i));
            names.push_back(model_.curves[i].id);
        }
        if (names.size() > 1) names.erase(names.begin()); // else a curve meets itself
        const std::string unit = " " + std::string(femoop::name(model_.units.length));
        return {femoop::FaultKind::PlacesMerged,
                {entries.front(), femoop::listed(names), place_text(model_, plane_.at(v)), rounded(here.apart) + unit,
                 rounded(plane_.snap()) + unit}};
    }

    const Drawing& drawing_;
    const PlaneModel& model_;
    const PlanarSubdivision& plane_;
    std::map<VertexId, std::vector<std::size_t>> points_; ///< that a vertex is
};

} // namespace

std::vector<femoop::Fault> merged_places(const Drawing& drawing) { return MergeSearch(drawing).run(); }

} // namespace discretize
