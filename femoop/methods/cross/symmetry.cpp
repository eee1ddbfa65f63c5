#include "femoop/methods/cross/symmetry.h"

#include <algorithm>
#include <cmath>

namespace femoop::cross {

namespace {

constexpr double same_place = 1e-9; // of the structure's width
constexpr double same_value = 1e-9; // of the largest of its kind

class Mirror {
public:
    Mirror(const Model& model, const Problem& problem, const Loading& loading)
        : model_(model), problem_(problem), loading_(loading)
    {}

    std::optional<Symmetry> find()
    {
        find_axis();
        if (!pair_nodes() || !pair_ends()) return std::nullopt;
        for (const SymmetryKind kind : {SymmetryKind::Symmetric, SymmetryKind::Antisymmetric}) {
            symmetry_.kind = kind;
            if (is_loading_paired() && choose_joints()) return std::move(symmetry_);
        }
        return std::nullopt;
    }

private:
    double x_of(NodeId node) const { return model_[node].at[0]; }
    double y_of(NodeId node) const { return model_[node].at[1]; }

    void find_axis()
    {
        const auto [left, right] = std::ranges::minmax(model_.nodes, {},
                                                       [](const Node& node) { return node.at[0].value(); });
        symmetry_.x = 0.5 * (left.at[0] + right.at[0]);
        width_ = right.at[0] - left.at[0];
    }

    bool pair_nodes()
    {
        for (std::size_t i = 0; i < model_.nodes.size(); ++i) {
            std::optional<NodeId> other;
            for (std::size_t j = 0; j < model_.nodes.size() && !other; ++j) {
                const bool is_level = std::abs(y_of(NodeId(i)) - y_of(NodeId(j))) <= same_place * width_;
                const double middle = 0.5 * (x_of(NodeId(i)) + x_of(NodeId(j)));
                if (is_level && std::abs(middle - symmetry_.x) <= same_place * width_) other = NodeId(j);
            }
            if (!other) return false;
            node_.push_back(*other);
        }
        return true;
    }

    NodeId far_node(const End& end) const { return end.member ? model_[*end.member].nodes[1 - end.which] : end.node; }

    bool pair_ends()
    {
        double largest = 0.0;
        for (const End& end : problem_.ends) largest = std::max(largest, end.stiffness);
        const auto is_image = [&](const End& a, const End& b) {
            return node_[a.node.index] == b.node && node_[far_node(a).index] == far_node(b) &&
                   a.member.has_value() == b.member.has_value() && a.joint.has_value() == b.joint.has_value() &&
                   a.is_overhang == b.is_overhang && a.is_hinged == b.is_hinged &&
                   std::abs(a.stiffness - b.stiffness) <= same_value * largest &&
                   std::abs(a.carry_over - b.carry_over) <= same_value;
        };
        std::vector<bool> is_taken(problem_.ends.size(), false);
        for (const End& end : problem_.ends) {
            std::size_t other = 0;
            while (other < is_taken.size() && (is_taken[other] || !is_image(end, problem_.ends[other]))) ++other;
            if (other == is_taken.size()) return false;
            is_taken[other] = true;
            symmetry_.mirror.emplace_back(other);
        }
        return true;
    }

    /// A mirrored moment turns the other way.
    double sign() const { return symmetry_.kind == SymmetryKind::Symmetric ? -1.0 : 1.0; }

    bool is_loading_paired() const
    {
        double largest = 0.0;
        for (const double moment : loading_.fixed_end) largest = std::max(largest, std::abs(moment));
        for (const double moment : loading_.joint_load) largest = std::max(largest, std::abs(moment));
        const auto is_pair = [&](double a, double b) { return std::abs(a - sign() * b) <= same_value * largest; };
        for (std::size_t e = 0; e < symmetry_.mirror.size(); ++e)
            if (!is_pair(loading_.fixed_end[e], loading_.fixed_end[symmetry_.mirror[e].index])) return false;
        for (std::size_t j = 0; j < problem_.joints.size(); ++j)
            if (!is_pair(loading_.joint_load[j], loading_.joint_load[image(JointId(j)).index])) return false;
        return true;
    }

    JointId image(JointId joint) const { return *problem_.joint_at(node_[problem_[joint].node.index]); }

    bool choose_joints()
    {
        symmetry_.balanced.clear();
        symmetry_.crossing.clear();
        for (std::size_t j = 0; j < problem_.joints.size(); ++j) {
            const double off = x_of(problem_.joints[j].node) - symmetry_.x;
            const bool is_on_axis = std::abs(off) <= same_place * width_;
            if (is_on_axis && symmetry_.kind == SymmetryKind::Antisymmetric) return false;
            if (is_on_axis || off > 0.0) continue;
            symmetry_.balanced.emplace_back(j);
            for (const EndId e : problem_.joints[j].ends)
                if (problem_[e].far == symmetry_.mirror[e.index] && problem_[e].far) symmetry_.crossing.push_back(e);
        }
        return true;
    }

    const Model& model_;
    const Problem& problem_;
    const Loading& loading_;
    Symmetry symmetry_;
    double width_ = 0.0;
    std::vector<NodeId> node_; ///< mirror image of every node
};

} // namespace

std::optional<Symmetry> symmetry_of(const Model& model, const Problem& problem, const Loading& loading)
{
    if (problem.joints.empty()) return std::nullopt;
    return Mirror(model, problem, loading).find();
}

Half half_of(const Problem& problem, const Loading& loading, const Symmetry& symmetry)
{
    Half half{.problem = problem, .loading = {.fixed_end = loading.fixed_end, .joint_load = {}}};
    const double sign = symmetry.kind == SymmetryKind::Symmetric ? -1.0 : 1.0;
    for (const EndId e : symmetry.crossing) {
        End& end = half.problem.ends[e.index];
        end.stiffness *= 1.0 + sign * end.carry_over;
        end.carry_over = 0.0;
    }
    half.problem.joints.clear();
    for (End& end : half.problem.ends) end.joint.reset();
    for (const JointId j : symmetry.balanced) {
        Joint joint = problem[j];
        joint.stiffness = 0.0;
        for (const EndId e : joint.ends) joint.stiffness += half.problem[e].stiffness;
        for (const EndId e : joint.ends) {
            half.problem.ends[e.index].joint = JointId(half.problem.joints.size());
            half.problem.ends[e.index].factor = half.problem[e].stiffness / joint.stiffness;
        }
        half.problem.joints.push_back(std::move(joint));
        half.loading.joint_load.push_back(loading.joint_load[j.index]);
    }
    half.problem.loading = half.loading;
    return half;
}

std::vector<double> whole_of(const Symmetry& symmetry, const Problem& half, const std::vector<double>& moments)
{
    const double sign = symmetry.kind == SymmetryKind::Symmetric ? -1.0 : 1.0;
    std::vector<double> whole = moments;
    const auto is_known = [&](EndId e) {
        return half[e].joint || (half[e].far && half[*half[e].far].joint && half[e].far != symmetry.mirror[e.index]);
    };
    for (std::size_t e = 0; e < whole.size(); ++e)
        if (!is_known(EndId(e)) && is_known(symmetry.mirror[e])) whole[e] = sign * moments[symmetry.mirror[e].index];
    return whole;
}

} // namespace femoop::cross
