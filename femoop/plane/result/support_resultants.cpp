#include "femoop/plane/result/support_resultants.h"

namespace femoop::plane {

namespace {

Eigen::Vector2d middle_along(const std::vector<CurveEdge>& edges, const std::vector<Eigen::Vector2d>& positions)
{
    double length = 0.0;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const CurveEdge& edge : edges) {
        const Eigen::Vector2d &a = positions[edge.start.index], &b = positions[edge.end.index];
        length += (b - a).norm();
        sum += 0.5 * (b - a).norm() * (a + b);
    }
    return sum / length;
}

} // namespace

std::vector<SupportResultant> support_resultants(const PlaneCase& result)
{
    const PlaneModel& model = result.structure().model();
    std::vector<bool> is_counted(model.points.size(), false);
    const auto add_nodes = [&](SupportResultant& to, const std::vector<NodeId>& nodes) {
        std::vector<NodeId> own;
        for (const NodeId node : nodes)
            if (!is_counted[node.index]) {
                is_counted[node.index] = true;
                own.push_back(node);
            }
        to.force = result.reaction(own);
        to.moment = result.reaction_moment(own, to.at);
    };
    std::vector<SupportResultant> all;
    for (std::size_t i = 0; i < model.points.size(); ++i) {
        if (!model.points[i].support) continue;
        SupportResultant& one = all.emplace_back();
        one.point = NodeId(i);
        one.at = result.structure().positions()[i];
        add_nodes(one, {NodeId(i)});
    }
    for (std::size_t c = 0; c < model.curves.size(); ++c) {
        const auto& edges = result.structure().curves().edges[c];
        if (!model.curves[c].support || edges.empty()) continue;
        SupportResultant& one = all.emplace_back();
        one.curve = CurveId(c);
        one.at = middle_along(edges, result.structure().positions());
        add_nodes(one, nodes_along(edges));
    }
    return all;
}

} // namespace femoop::plane
