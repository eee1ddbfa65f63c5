#include "femoop/plane/mesh/edge_table.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace femoop::plane {

namespace {

NodeId node_at(const PlaneElement& element, const Shape::Edge& edge, std::size_t i)
{
    return element.points[static_cast<std::size_t>(edge[i])];
}

std::optional<NodeId> middle_of(const PlaneModel& model, const ElementEdge& at)
{
    const PlaneElement& element = model[at.element];
    const Shape::Edge edge = shape_of(element.kind).edges()[static_cast<std::size_t>(at.edge)];
    if (edge.size() < 3) return std::nullopt;
    return node_at(element, edge, 2);
}

/// Does a run of the curve's points begin here?
bool begins_run(const PlaneCurve& curve, std::size_t i)
{
    if (!curve.reach) return i == 0;
    return std::ranges::any_of(curve.reach->runs, [&](const CurveReach::Run& run) { return run.first == i; });
}

std::optional<CurveEdge> edge_between(const PlaneModel& model, const EdgeTable& table, NodeId start, NodeId end)
{
    CurveEdge found{
        .start = start, .end = end, .middle = {}, .left = table.find(start, end), .right = table.find(end, start)};
    if (!found.left && !found.right) return std::nullopt;
    found.middle = middle_of(model, found.left ? *found.left : *found.right);
    return found;
}

} // namespace

bool has_points(const PlaneModel& model, const PlaneElement& element)
{
    const auto n = static_cast<std::size_t>(shape_of(element.kind).n_nodes());
    return element.points.size() == n && std::all_of(element.points.begin(), element.points.end(),
                                                     [&](NodeId point) { return point.index < model.points.size(); });
}

EdgeTable::EdgeTable(const PlaneModel& model) : first_(model.points.size() + 1, 0)
{
    const auto for_each_edge = [&](auto&& use) {
        for (std::size_t e = 0; e < model.elements.size(); ++e) {
            const PlaneElement& element = model.elements[e];
            if (!has_points(model, element)) continue;
            for (int i = 0; const Shape::Edge edge : shape_of(element.kind).edges())
                use(node_at(element, edge, 0), node_at(element, edge, 1),
                    ElementEdge{.element = ElementId(e), .edge = i++});
        }
    };
    for_each_edge([&](NodeId start, NodeId, ElementEdge) { ++first_[start.index + 1]; });
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    entries_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for_each_edge([&](NodeId start, NodeId end, ElementEdge edge) { entries_[next[start.index]++] = {end, edge}; });
}

std::optional<ElementEdge> EdgeTable::find(NodeId start, NodeId end) const
{
    if (start.index + 1 >= first_.size()) return std::nullopt;
    for (std::uint32_t i = first_[start.index]; i < first_[start.index + 1]; ++i)
        if (entries_[i].end == end) return entries_[i].edge;
    return std::nullopt;
}

CurveEdges edges_along(const PlaneModel& model, const EdgeTable& table, const PlaneCurve& curve)
{
    CurveEdges found;
    const std::vector<NodeId>& points = curve.points;
    bool is_first = true;
    for (std::size_t i = 0; i + 1 < points.size();) {
        if (i > 0 && begins_run(curve, i + 1)) {
            is_first = true;
            ++i;
            continue;
        }
        std::optional<CurveEdge> edge = edge_between(model, table, points[i], points[i + 1]);
        std::size_t next = i + 1;
        if (!edge && i + 2 < points.size()) { // the point between may be the middle node
            edge = edge_between(model, table, points[i], points[i + 2]);
            if (edge && edge->middle != points[i + 1]) edge.reset();
            next = i + 2;
        }
        if (!edge) {
            found.gap = i;
            return found;
        }
        edge->begins_run = std::exchange(is_first, false);
        found.edges.push_back(*edge);
        i = next;
    }
    return found;
}

std::vector<NodeId> nodes_along(const std::vector<CurveEdge>& edges)
{
    std::vector<NodeId> nodes;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (i > 0 && edges[i].begins_run) nodes.push_back(edges[i - 1].end);
        nodes.push_back(edges[i].start);
        if (edges[i].middle) nodes.push_back(*edges[i].middle);
    }
    if (!edges.empty() && edges.back().end != edges.front().start) nodes.push_back(edges.back().end);
    return nodes;
}

} // namespace femoop::plane
