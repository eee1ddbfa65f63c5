#include "femoop/methods/cross/symmetry.h"

#include <algorithm>
#include <cmath>

#include "femoop/methods/cross/rounding.h"
#include "femoop/methods/cross/virtual_work.h"
#include "femoop/model/fault/fault.h"
#include "femoop/model/quantity/number_text.h"

namespace femoop::cross {

namespace {

constexpr double same_place = 1e-9; // of the structure's extent
constexpr double same_value = 1e-9; // of the largest of its kind
constexpr int shown_place_digits = 6;

bool is_crossing(const Problem& problem, const std::vector<EndId>& image, EndId end)
{
    return problem[end].joint && problem[end].far && problem[end].far == image[end.index];
}

/// Finds what stands where on the other side of the axis, and says what does not.
class Halver {
public:
    Halver(const Model& model, const Problem& whole) : model_(model), whole_(whole)
    {
        for (const Node& node : model.nodes) place_.emplace_back(node.at[0].value(), node.at[1].value());
        const auto [left, right] = std::ranges::minmax(place_, {}, [](const auto& at) { return at.x(); });
        x_ = 0.5 * (left.x() + right.x());
        const auto [low, high] = std::ranges::minmax(place_, {}, [](const auto& at) { return at.y(); });
        near_ = same_place * std::max(right.x() - left.x(), high.y() - low.y());
        pair_nodes();
        pair_ends();
        for (const Joint& joint : whole.joints) joints_.push_back(*whole.joint_at(node_[joint.node.index]));
    }

    /// Each sheet's half, and the sways that the loads cause alone.
    Problem halved() const
    {
        Problem halved = whole_;
        const SymmetryKind kind = kind_of_loads();
        std::vector<SymmetryKind> kinds;
        for (const Sway& sway : whole_.sways) kinds.push_back(kind_of(sway));
        const std::vector<bool> is_idle = idle_sways(kind, kinds);
        halved.sways.clear();
        halved.halves.push_back(half(kind, whole_.loading));
        for (std::size_t k = 0; k < kinds.size(); ++k) {
            if (is_idle[k]) continue;
            halved.sways.push_back(whole_.sways[k]);
            halved.halves.push_back(half(kinds[k], whole_.sways[k].loading));
        }
        return halved;
    }

private:
    std::string axis() const { return quantity_text(rounded(x_, shown_place_digits), dimension::length, model_.units); }
    std::string point(const Eigen::Vector2d& at) const
    {
        const std::string unit = unit_text(dimension::length, model_.units);
        return "(" + number_text(rounded(at.x(), shown_place_digits) + 0.0) + ", " +
               number_text(rounded(at.y(), shown_place_digits) + 0.0) + ") " + unit;
    }
    std::string moment(double value) const
    {
        return quantity_text(rounded(value, shown_place_digits) + 0.0, dimension::moment, model_.units);
    }

    void pair_nodes()
    {
        for (std::size_t i = 0; i < place_.size(); ++i) {
            const Eigen::Vector2d wanted(2.0 * x_ - place_[i].x(), place_[i].y());
            const auto is_there = [&](const Eigen::Vector2d& at) {
                return (at - wanted).cwiseAbs().maxCoeff() <= near_;
            };
            const auto other = std::ranges::find_if(place_, is_there);
            if (other == place_.end())
                throw ModelError({{FaultKind::CrossNodeWithoutImage, {model_.nodes[i].id, axis(), point(wanted)}}});
            node_.emplace_back(static_cast<std::size_t>(other - place_.begin()));
        }
    }

    NodeId far_node(const End& end) const { return end.member ? model_[*end.member].nodes[1 - end.which] : end.node; }

    void pair_ends()
    {
        double largest = 0.0;
        for (const End& end : whole_.ends) largest = std::max(largest, end.stiffness);
        const auto is_image = [&](const End& a, const End& b) {
            return node_[a.node.index] == b.node && node_[far_node(a).index] == far_node(b) &&
                   a.member.has_value() == b.member.has_value() && a.joint.has_value() == b.joint.has_value() &&
                   a.is_overhang == b.is_overhang && a.is_hinged == b.is_hinged &&
                   std::abs(a.stiffness - b.stiffness) <= same_value * largest &&
                   std::abs(a.carry_over - b.carry_over) <= same_value;
        };
        std::vector<std::vector<EndId>> ends_at(model_.nodes.size());
        for (std::size_t e = 0; e < whole_.ends.size(); ++e) ends_at[whole_.ends[e].node.index].emplace_back(e);
        for (const End& end : whole_.ends) {
            // A member that crosses the axis is its own image, even where another lies beside it.
            const NodeId there = node_[end.node.index];
            std::vector<EndId>& others = ends_at[there.index];
            auto other = end.far ? std::ranges::find(others, *end.far) : others.end();
            if (other == others.end() || !is_image(end, whole_[*other]))
                other = std::ranges::find_if(others, [&](EndId e) { return is_image(end, whole_[e]); });
            if (other == others.end())
                throw ModelError({{FaultKind::CrossEndWithoutImage, {end.label, axis(), model_[there].id}}});
            ends_.push_back(*other);
            others.erase(other);
        }
    }

    static double sign(SymmetryKind kind) { return kind == SymmetryKind::Symmetric ? -1.0 : 1.0; }

    /// A moment and that of its image, where they are neither equal nor opposite as the kind wants.
    struct Skew {
        std::string name, image;
        double moment = 0.0, image_moment = 0.0;
    };
    std::optional<Skew> skew_of(const Loading& loading, SymmetryKind kind) const
    {
        double largest = 0.0;
        for (const double moment : loading.fixed_end) largest = std::max(largest, std::abs(moment));
        for (const double moment : loading.joint_load) largest = std::max(largest, std::abs(moment));
        const auto is_pair = [&](double a, double b) { return std::abs(a - sign(kind) * b) <= same_value * largest; };
        for (std::size_t e = 0; e < ends_.size(); ++e)
            if (const double own = loading.fixed_end[e], other = loading.fixed_end[ends_[e].index];
                !is_pair(own, other))
                return Skew{whole_.ends[e].label, whole_[ends_[e]].label, own, other};
        for (std::size_t j = 0; j < joints_.size(); ++j)
            if (const double own = loading.joint_load[j], other = loading.joint_load[joints_[j].index];
                !is_pair(own, other))
                return Skew{model_[whole_.joints[j].node].id, model_[whole_[joints_[j]].node].id, own, other};
        return std::nullopt;
    }

    /// Loads that lock nothing may be of either kind: then they are what the sways that they cause are.
    SymmetryKind kind_of_loads() const
    {
        const auto symmetric = skew_of(whole_.loading, SymmetryKind::Symmetric);
        const auto antisymmetric = skew_of(whole_.loading, SymmetryKind::Antisymmetric);
        if (symmetric && antisymmetric) {
            const bool is_opposite = std::abs(symmetric->moment) == std::abs(symmetric->image_moment);
            const Skew& skew = is_opposite ? *antisymmetric : *symmetric;
            throw ModelError({{FaultKind::CrossSkewLoads,
                               {skew.name, moment(skew.moment), skew.image, moment(skew.image_moment), axis()}}});
        }
        if (symmetric) return SymmetryKind::Antisymmetric;
        if (antisymmetric) return SymmetryKind::Symmetric;
        const std::vector<double> held = held_by(nullptr);
        for (std::size_t k = 0; k < held.size(); ++k)
            if (held[k] != 0.0) return kind_of(whole_.sways[k]);
        return SymmetryKind::Symmetric;
    }

    SymmetryKind kind_of(const Sway& sway) const
    {
        for (const SymmetryKind kind : {SymmetryKind::Symmetric, SymmetryKind::Antisymmetric})
            if (!skew_of(sway.loading, kind)) return kind;
        throw ModelError({{FaultKind::CrossSkewSway, {model_[sway.prop].id, axis()}}});
    }

    /// Forces of the props with every joint locked, in the loaded structure or in a sway.
    std::vector<double> held_by(const Sway* sway) const
    {
        const std::vector<double> locked(whole_.joints.size(), 0.0);
        if (sway == nullptr) return holding_forces(whole_, {whole_.loading.fixed_end, locked});
        return holding_forces(whole_, {sway->loading.fixed_end, locked}, *sway);
    }

    /// Sways of the other kind that neither the loads nor the sways of their kind push.
    std::vector<bool> idle_sways(SymmetryKind kind, const std::vector<SymmetryKind>& kinds) const
    {
        std::vector<bool> is_idle;
        for (const SymmetryKind own : kinds) is_idle.push_back(own != kind);
        const auto is_pushed = [&](const std::vector<double>& held) {
            for (std::size_t k = 0; k < held.size(); ++k)
                if (kinds[k] != kind && held[k] != 0.0) return true;
            return false;
        };
        bool is_any_pushed = is_pushed(held_by(nullptr));
        for (std::size_t k = 0; k < kinds.size(); ++k)
            is_any_pushed = is_any_pushed || (kinds[k] == kind && is_pushed(held_by(&whole_.sways[k])));
        return is_any_pushed ? std::vector<bool>(kinds.size(), false) : is_idle;
    }

    Mirror mirror(SymmetryKind kind) const
    {
        Mirror mirror{.kind = kind, .x = x_, .ends = ends_, .joints = joints_, .is_balanced = {}, .is_on_sheet = {}};
        const bool turns_on_axis = kind == SymmetryKind::Antisymmetric;
        const auto is_left_of = [&](NodeId node, double off) { return place_[node.index].x() < x_ + off; };
        for (const Joint& joint : whole_.joints)
            mirror.is_balanced.push_back(is_left_of(joint.node, turns_on_axis ? near_ : -near_));
        for (const End& end : whole_.ends) {
            const bool is_on_axis = is_left_of(end.node, near_) && !is_left_of(end.node, -near_);
            mirror.is_on_sheet.push_back(is_left_of(end.node, -near_) ||
                                         (is_on_axis && (turns_on_axis || is_left_of(far_node(end), near_))));
        }
        return mirror;
    }

    Problem half(SymmetryKind kind, const Loading& loading) const
    {
        Problem half{.load_case = whole_.load_case,
                     .far_ends = whole_.far_ends,
                     .ends = whole_.ends,
                     .joints = whole_.joints,
                     .members = whole_.members,
                     .loading = loading,
                     .sways = {},
                     .springs = {},
                     .imposed = {},
                     .node_force = {},
                     .halves = {},
                     .mirror = mirror(kind)};
        for (std::size_t e = 0; e < half.ends.size(); ++e) {
            if (!is_crossing(whole_, ends_, EndId(e))) continue;
            half.ends[e].stiffness *= 1.0 + sign(kind) * half.ends[e].carry_over;
            half.ends[e].carry_over = 0.0;
        }
        for (Joint& joint : half.joints) {
            joint.stiffness = 0.0;
            for (const EndId e : joint.ends) joint.stiffness += half[e].stiffness;
            for (const EndId e : joint.ends) half.ends[e.index].factor = half[e].stiffness / joint.stiffness;
        }
        return half;
    }

    const Model& model_;
    const Problem& whole_;
    std::vector<Eigen::Vector2d> place_; ///< of every node
    double x_ = 0.0, near_ = 0.0;        ///< of the axis, and what still counts as on it
    std::vector<NodeId> node_;           ///< mirror image of every node
    std::vector<EndId> ends_;            ///< of every end
    std::vector<JointId> joints_;        ///< of every joint
};

} // namespace

Problem by_halves(const Model& model, const Problem& whole) { return Halver(model, whole).halved(); }

std::vector<EndId> crossing_ends(const Problem& half)
{
    std::vector<EndId> crossing;
    for (std::size_t e = 0; e < half.ends.size(); ++e)
        if (half.is_on_sheet(EndId(e)) && is_crossing(half, half.mirror->ends, EndId(e))) crossing.emplace_back(e);
    return crossing;
}

} // namespace femoop::cross
