#include "femoop/plane/result/support_resultants.h"

#include <algorithm>

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

/// Gives every support its share of the reactions of its nodes.
class Sharing {
public:
    explicit Sharing(const PlaneCase& result)
        : result_(result), model_(result.structure().model()), n_to_come_(model_.points.size(), 0)
    {
        for (std::size_t i = 0; i < model_.points.size(); ++i) {
            left_.push_back(result.reaction(NodeId(i)));
            if (model_.points[i].support) ++n_to_come_[i];
        }
        for_held_curves([&](CurveId, const CurveNode& node) { ++n_to_come_[node.node.index]; });
    }

    std::vector<SupportResultant> run()
    {
        std::vector<SupportResultant> all;
        for (std::size_t i = 0; i < model_.points.size(); ++i) {
            if (!model_.points[i].support) continue;
            SupportResultant& one = all.emplace_back();
            one.point = NodeId(i);
            one.at = place(NodeId(i));
            add(one, NodeId(i), *model_.points[i].support, nullptr);
        }
        for_held_curves([&](CurveId curve, const CurveNode& node) {
            if (all.empty() || all.back().curve != curve) {
                SupportResultant& one = all.emplace_back();
                one.curve = curve;
                one.at = middle_along(result_.structure().curves().edges[curve.index], result_.structure().positions());
            }
            add(all.back(), node.node, *model_[curve].support, &node);
        });
        return all;
    }

private:
    template <class Use> void for_held_curves(const Use& use) const
    {
        const CurveTable& curves = result_.structure().curves();
        for (std::size_t c = 0; c < model_.curves.size(); ++c)
            if (model_.curves[c].support)
                for (const CurveNode& node : curves.geometry[c].nodes()) use(CurveId(c), node);
    }

    const Eigen::Vector2d& place(NodeId node) const { return result_.structure().positions()[node.index]; }

    void add(SupportResultant& to, NodeId node, const PlaneSupport& support, const CurveNode* on_curve)
    {
        Eigen::Vector2d& left = left_[node.index];
        const bool is_last = --n_to_come_[node.index] == 0;
        const Eigen::Vector2d force = is_last ? left
                                              : along(left, result_.structure().supports().held_by(support, on_curve));
        left -= force;
        const Eigen::Vector2d arm = place(node) - to.at;
        to.force += force;
        to.moment += arm.x() * force.y() - arm.y() * force.x();
    }

    /// What of a force acts along one direction; all of it where there are two.
    static Eigen::Vector2d along(const Eigen::Vector2d& force, const std::vector<HeldDirection>& held)
    {
        if (held.empty()) return Eigen::Vector2d::Zero();
        const HeldDirection& first = held.front();
        if (!std::ranges::all_of(held, [&](const HeldDirection& other) { return are_one(first, other); })) return force;
        return force.dot(first.direction) * first.direction;
    }

    const PlaneCase& result_;
    const PlaneModel& model_;
    std::vector<Eigen::Vector2d> left_; ///< of the reactions of nodes
    std::vector<int> n_to_come_;        ///< supports of nodes
};

} // namespace

std::vector<SupportResultant> support_resultants(const PlaneCase& result) { return Sharing(result).run(); }

} // namespace femoop::plane
