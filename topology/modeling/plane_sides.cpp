#include "topology/modeling/plane_sides.h"

#include <algorithm>
#include <cmath>

#include "topology/modeling/mass_properties.h"

namespace topology {

namespace {

class Sorter {
public:
    Sorter(const Solid& solid, const Plane& plane) : solid_(solid), plane_(plane) {}

    PlaneSides sort()
    {
        measure();
        for (const VertexId v : solid_.vertices())
            sides_.is_above[v.index] = height(v) > 0.0 || (height(v) == 0.0 && rises(v));
        is_settled_.resize(sides_.height.size());
        for (const FaceId f : solid_.faces())
            if (lies_in_plane(f)) leave_to_its_part(f);
        return sides_;
    }

private:
    double height(VertexId v) const { return sides_.height[v.index]; }

    void measure()
    {
        constexpr double rounding = 1e-12;
        double reach = 0.0;
        for (const VertexId v : solid_.vertices()) {
            const Point& p = solid_.point(v);
            reach = std::max({reach, length(p - Point{}), length(p - plane_.origin)});
        }
        const std::size_t n = solid_.vertices().n_rows();
        sides_.height.resize(n);
        sides_.is_above.resize(n);
        for (const VertexId v : solid_.vertices()) {
            const double at = plane_.height(solid_.point(v));
            sides_.height[v.index] = std::abs(at) > rounding * length(plane_.normal) * reach ? at : 0.0;
        }
    }

    bool rises(VertexId v) const
    {
        for (const HalfEdgeId h : solid_.fan(v))
            if (height(solid_.end(h)) > 0.0) return true;
        return false;
    }

    bool lies_in_plane(FaceId f) const
    {
        for (const HalfEdgeId h : solid_.chain(solid_.outer(f)))
            if (height(solid_.start(h)) != 0.0) return false;
        return true;
    }

    // The material of a face that looks up lies below.
    void leave_to_its_part(FaceId f)
    {
        const bool is_above = dot(area_vector(solid_, f), plane_.normal) < 0.0;
        for (const LoopId l : solid_.loops(f))
            for (const HalfEdgeId h : solid_.chain(l)) settle(solid_.start(h), is_above);
    }

    void settle(VertexId v, bool is_above)
    {
        if (is_settled_[v.index] && sides_.is_above[v.index] != is_above) sides_.torn = v;
        is_settled_[v.index] = true;
        sides_.is_above[v.index] = is_above;
    }

    const Solid& solid_;
    const Plane& plane_;
    PlaneSides sides_;
    std::vector<bool> is_settled_;
};

} // namespace

PlaneSides sides_of(const Solid& solid, const Plane& plane) { return Sorter(solid, plane).sort(); }

} // namespace topology
