#include "topology/planar/curve_insertion.h"

#include <algorithm>

namespace topology {

namespace {

bool is_between(double t, Span span) { return std::min(span.from, span.to) <= t && t <= std::max(span.from, span.to); }

} // namespace

CurveInsertion::CurveInsertion(PlanarSubdivision& into, Span span, const std::array<FlatPoint, 2>& ends)
    : into_(into),
      curve_(into.curves_.back()),
      span_(span),
      ends_(ends),
      index_(static_cast<CurveIndex>(into.curves_.size() - 1))
{}

void CurveInsertion::gather_edges()
{
    const Solid& solid = into_.solid_;
    std::vector<bool>&is_seen = into_.is_seen_edge_, &is_seen_vertex = into_.is_seen_vertex_;
    is_seen.resize(solid.edges().n_rows());
    is_seen_vertex.resize(solid.vertices().n_rows());
    std::vector<std::uint32_t> seen;
    const double reach = 2.0 * into_.snap_;
    into_.edges_.along(curve_, span_, reach, [&](std::uint32_t number) {
        if (number >= is_seen.size() || is_seen[number]) return; // one that was undone
        is_seen[number] = true;
        seen.push_back(number);
        if (solid.has(EdgeId{number}) && !is_beside(EdgeId{number}, reach)) near_edges_.push_back(EdgeId{number});
    });
    for (const std::uint32_t number : seen) is_seen[number] = false;
    const auto see = [&](VertexId v) {
        if (is_seen_vertex[v.index]) return;
        is_seen_vertex[v.index] = true;
        near_vertices_.push_back(v);
    };
    for (const EdgeId e : near_edges_)
        for (const HalfEdgeId h : {solid.plus(e), solid.minus(e)}) see(solid.start(h));
    into_.points_.along(curve_, span_, reach, [&](std::uint32_t number) {
        if (solid.has(VertexId{number})) see(VertexId{number});
    });
    for (const VertexId v : near_vertices_) is_seen_vertex[v.index] = false;
    std::ranges::sort(near_edges_); // so that what is found does not depend on cells
    std::ranges::sort(near_vertices_);
}

/// Of two straight ones: farther than reach, on one side.
bool CurveInsertion::is_beside(EdgeId e, double reach) const
{
    if (!curve_.is_straight() || !into_.is_straight(into_.parts_[e.index])) return false;
    const HalfEdgeId plus = into_.solid_.plus(e);
    const FlatVector along = ends_[1] - ends_[0];
    const double a = cross(along, into_.at(into_.solid_.start(plus)) - ends_[0]);
    const double b = cross(along, into_.at(into_.solid_.end(plus)) - ends_[0]);
    const double most = reach * length(along);
    return std::min(a, b) > most || std::max(a, b) < -most;
}

void CurveInsertion::meet_vertex(VertexId v)
{
    const FlatPoint p = into_.at(v);
    for (std::size_t i = 0; i < 2; ++i)
        if (is_near(p, ends_[i]) && !end_vertices_[i]) end_vertices_[i] = v;
    if (is_at_end(p)) return;
    const double t = curve_.nearest(p, span_);
    if (is_near(curve_.at(t), p)) nodes_.push_back({.t = t, .at = p, .vertex = v, .edge = {}});
}

/// Ends of the curve on edges.
void CurveInsertion::meet_ends(EdgeId e)
{
    const CurvePart& part = into_.parts_[e.index];
    const Curve& other = into_.curves_[part.curve];
    for (std::size_t i = 0; i < 2; ++i) {
        if (end_vertices_[i] || end_edges_[i]) continue;
        const double u = other.nearest(ends_[i], part.span);
        if (is_near(other.at(u), ends_[i])) end_edges_[i] = {e, u};
    }
}

const CurveContacts& CurveInsertion::contacts_with(CurveIndex other)
{
    const auto found = contacts_.find(other);
    if (found != contacts_.end()) return found->second;
    return contacts_.emplace(other, contacts(curve_, into_.curves_[other], into_.snap_)).first->second;
}

/// Crossings inside the edge, away from its ends and the curve's own. \returns whether the two run together
bool CurveInsertion::meet_curve(EdgeId e)
{
    const CurvePart& part = into_.parts_[e.index];
    if (part.curve == index_) return false; // its crossing with itself is a vertex
    const HalfEdgeId plus = into_.solid_.plus(e);
    const FlatPoint start = into_.at(into_.solid_.start(plus)), end = into_.at(into_.solid_.end(plus));
    const bool are_straight = curve_.is_straight() && into_.curves_[part.curve].is_straight();
    if (are_straight && turn(ends_[0], ends_[1], start) * turn(ends_[0], ends_[1], end) > 0.0) return false;
    const CurveContacts straight = are_straight ? contacts(curve_, into_.curves_[part.curve], into_.snap_)
                                                : CurveContacts{};
    const CurveContacts& found = are_straight ? straight : contacts_with(part.curve);
    if (found.run_together) return true;
    for (const CurveContact& contact : found.places) {
        if (!is_between(contact.u, part.span) || !is_between(contact.t, span_) || is_at_end(contact.at)) continue;
        if (is_near(contact.at, start) || is_near(contact.at, end)) continue;
        nodes_.push_back({.t = contact.t, .at = contact.at, .vertex = {}, .edge = e, .u = contact.u});
    }
    return false;
}

std::optional<InsertionRefusal> CurveInsertion::find_meetings()
{
    gather_edges();
    for (const VertexId v : near_vertices_) meet_vertex(v);
    for (const EdgeId e : near_edges_) meet_ends(e);
    for (const EdgeId e : near_edges_)
        if (meet_curve(e)) return InsertionRefusal{into_.parts_[e.index].curve};
    order_nodes();
    return std::nullopt;
}

CurveInsertion::Node CurveInsertion::end(std::size_t which) const
{
    Node node{.t = which == 0 ? span_.from : span_.to, .at = ends_[which], .vertex = end_vertices_[which], .edge = {}};
    if (node.vertex || !end_edges_[which]) return node;
    node.edge = end_edges_[which]->first;
    node.u = end_edges_[which]->second;
    return node;
}

/// Along the curve; vertices before edges at one place.
void CurveInsertion::order_nodes()
{
    std::ranges::sort(nodes_, [](const Node& a, const Node& b) {
        return std::pair(a.t, !a.vertex.has_value()) < std::pair(b.t, !b.vertex.has_value());
    });
    nodes_.insert(nodes_.begin(), end(0));
    nodes_.push_back(end(1));
}

/// The part of the edge that the node lies on, after this insertion has cut some off.
EdgeId CurveInsertion::edge_at(const Node& node) const
{
    for (auto split = splits_.rbegin(); split != splits_.rend(); ++split)
        if (split->first == *node.edge && !is_between(node.u, into_.parts_[node.edge->index].span) &&
            is_between(node.u, into_.parts_[split->second.index].span))
            return split->second;
    return *node.edge;
}

/// Makes the node a vertex where it lies on an edge.
void CurveInsertion::realize(Node& node)
{
    if (node.vertex || !node.edge) return;
    const EdgeId e = edge_at(node);
    const EdgeId cut_off = EdgeId{static_cast<std::uint32_t>(into_.solid_.edges().n_rows())};
    node.vertex = into_.split(e, node.u, node.at);
    const std::size_t n_before = splits_.size();
    for (std::size_t i = 0; i < n_before; ++i)
        if (splits_[i].second == e) splits_.emplace_back(splits_[i].first, cut_off);
    splits_.emplace_back(e, cut_off);
}

/// The node's edge is led through a vertex that it passes closer than snap.
void CurveInsertion::join_to(const Node& node, VertexId v)
{
    const EdgeId e = edge_at(node);
    if (!into_.solid_.has(e)) return; // it became one with another
    const HalfEdgeId plus = into_.solid_.plus(e);
    const bool ends_there = into_.solid_.start(plus) == v || into_.solid_.end(plus) == v;
    if (!ends_there) into_.reroute(e, node.u, v);
}

/// Places on edges that are as good as a vertex which the curve passes.
void CurveInsertion::join_to_vertices()
{
    const auto sweep = [&](auto begin, auto end) {
        const Node* passed = nullptr;
        for (auto node = begin; node != end; ++node) {
            if (node->vertex) passed = &*node;
            else if (passed != nullptr && node->edge && is_near(passed->at, node->at)) node->joins = passed->vertex;
        }
    };
    sweep(nodes_.begin() + 1, nodes_.end() - 1);
    sweep(nodes_.rbegin() + 1, nodes_.rend() - 1);
}

/// Makes every place but a free end a vertex; places that are one become one.
void CurveInsertion::cut()
{
    join_to_vertices();
    std::vector<Node> cuts;
    for (Node& node : nodes_) {
        const bool is_last = &node == &nodes_.back();
        if (is_last && is_closed()) {
            node.vertex = cuts.front().vertex;
        } else if (node.joins) {
            join_to(node, *node.joins);
            continue;
        } else if (cuts.size() > 1 && !is_last && is_near(cuts.back().at, node.at) && !node.vertex) {
            join_to(node, *cuts.back().vertex);
            continue;
        } else {
            realize(node);
        }
        cuts.push_back(node);
    }
    nodes_ = std::move(cuts);
}

void CurveInsertion::insert()
{
    cut();
    Node &first = nodes_.front(), &second = nodes_[1];
    std::size_t next = 1;
    if (!first.vertex && second.vertex) { // a beginning that hangs free grows backwards
        first.vertex = into_.grow(*second.vertex, first.at, {index_, {second.t, first.t}});
        next = 2;
    } else if (!first.vertex) {
        first.vertex = into_.lone_vertex(first.at);
    }
    if (is_closed()) nodes_.back().vertex = first.vertex;
    for (std::size_t i = next; i < nodes_.size(); ++i) {
        const Node& before = nodes_[i - 1];
        const CurvePart part{index_, {before.t, nodes_[i].t}};
        if (nodes_[i].vertex) into_.connect(*before.vertex, *nodes_[i].vertex, part);
        else nodes_[i].vertex = into_.grow(*before.vertex, nodes_[i].at, part);
    }
}

std::optional<InsertionRefusal> PlanarSubdivision::insert(const Curve& curve, const std::array<FlatPoint, 2>& ends)
{
    FlatBox box = curve.box({});
    for (const FlatPoint& end : ends) box.add(end);
    fit_grid(box);
    begin();
    curves_.push_back(curve);
    if (const auto refusal = CurveInsertion(*this, {}, ends).find_meetings()) {
        curves_.pop_back();
        marks_.pop_back();
        return refusal;
    }
    try {
        insert_parts(ends);
    } catch (const std::runtime_error&) { // tangled, or a piece would have to cross others
        undo();
        return InsertionRefusal{};
    }
    return std::nullopt;
}

/// Of the last curve: one that crosses itself is three parts that do not.
void PlanarSubdivision::insert_parts(const std::array<FlatPoint, 2>& ends)
{
    std::vector<double> cuts = curves_.back().self_crossing();
    const FlatPoint crossing = cuts.empty() ? ends[1] : curves_.back().at(cuts.front());
    cuts.push_back(1.0);
    FlatPoint from = ends[0];
    double t = 0.0;
    for (const double cut : cuts) {
        const FlatPoint to = cut == 1.0 ? ends[1] : crossing;
        if (cut > t) {
            CurveInsertion insertion(*this, {t, cut}, {from, to});
            insertion.find_meetings();
            insertion.insert();
        }
        t = cut;
        from = to;
    }
}

VertexId PlanarSubdivision::insert(const FlatPoint& point)
{
    fit_grid({point, point});
    begin();
    const Curve here(Segment{point, point});
    std::optional<VertexId> vertex;
    const auto see = [&](VertexId v) {
        if (distance(at(v), point) <= snap_) vertex = v;
    };
    edges_.along(here, {}, 2.0 * snap_, [&](std::uint32_t number) {
        if (const EdgeId e{number}; solid_.has(e))
            for (const HalfEdgeId h : {solid_.plus(e), solid_.minus(e)}) see(solid_.start(h));
    });
    points_.along(here, {}, 2.0 * snap_, [&](std::uint32_t number) {
        if (const VertexId v{number}; solid_.has(v)) see(v);
    });
    if (vertex) return *vertex;
    if (const auto edge = edge_at(point))
        return split(*edge, curves_[part(*edge).curve].nearest(point, part(*edge).span), point);
    return lone_vertex(point);
}

} // namespace topology
