#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "topology/geometry/curve_contact.h"
#include "topology/planar/planar_subdivision.h"

namespace topology {

/// One curve on its way into a subdivision: where it meets what is there is found first, so that nothing has changed
/// if it cannot be put in; then it is cut there, and its pieces become edges.
class CurveInsertion {
public:
    /// Of a part of the last of the subdivision's curves.
    CurveInsertion(PlanarSubdivision& into, Span span, const std::array<FlatPoint, 2>& ends);

    std::optional<InsertionRefusal> find_meetings();
    void insert(); ///< \pre nothing runs together

private:
    /// A place of the curve that is, or becomes, a vertex.
    struct Node {
        double t = 0.0;
        FlatPoint at;
        std::optional<VertexId> vertex;
        std::optional<EdgeId> edge; ///< that is met there, at its curve's u
        double u = 0.0;
        std::optional<VertexId> joins{}; ///< a vertex that the edge is led through
    };

    void gather_edges();
    bool is_beside(EdgeId e, double reach) const;
    void meet_vertex(VertexId v);
    void meet_lone_vertices();
    void meet_ends(EdgeId e);
    bool meet_curve(EdgeId e);
    const CurveContacts& contacts_with(CurveIndex other);
    bool is_at_end(const FlatPoint& p) const { return is_near(p, ends_[0]) || is_near(p, ends_[1]); }
    bool is_near(const FlatPoint& p, const FlatPoint& q) const { return distance(p, q) <= into_.snap_; }
    Node end(std::size_t which) const;

    void order_nodes();
    void realize(Node& node);
    void join_to(const Node& node, VertexId v);
    void join_to_vertices();
    void cut();
    bool is_closed() const { return is_near(ends_[0], ends_[1]); }
    EdgeId edge_at(const Node& node) const;

    PlanarSubdivision& into_;
    const Curve& curve_;
    Span span_;
    std::array<FlatPoint, 2> ends_;
    CurveIndex index_;
    std::vector<EdgeId> near_edges_;
    std::vector<VertexId> near_vertices_;
    std::array<std::optional<VertexId>, 2> end_vertices_;
    std::array<std::optional<std::pair<EdgeId, double>>, 2> end_edges_;
    std::unordered_map<CurveIndex, CurveContacts> contacts_;
    std::vector<Node> nodes_;
    std::vector<std::pair<EdgeId, EdgeId>> splits_; ///< an edge and what was cut off it, in this insertion
};

} // namespace topology
