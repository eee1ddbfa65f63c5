#include "femoop/methods/truss/section_method.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "femoop/geometry/plane_vectors.h"

namespace femoop::truss {

namespace {

constexpr double negligible_arm = 1e-9; // of the size of the truss
constexpr int no_part = -1;

/// Which joints hang together by bars that are not left out.
template <class IsKept> std::vector<int> parts_of(const Truss& truss, const IsKept& is_kept)
{
    std::vector<int> part(truss.joints.size(), no_part);
    int n = 0;
    for (std::size_t i = 0; i < truss.joints.size(); ++i) {
        if (part[i] != no_part || truss.bars_at[i].empty()) continue;
        std::vector<NodeId> waiting{NodeId(i)};
        part[i] = n;
        while (!waiting.empty()) {
            const NodeId joint = waiting.back();
            waiting.pop_back();
            for (const MemberId bar : truss.bars_at[joint.index]) {
                const NodeId other = truss.other_joint(bar, joint);
                if (!is_kept(bar) || part[other.index] != no_part) continue;
                part[other.index] = n;
                waiting.push_back(other);
            }
        }
        ++n;
    }
    return part;
}

bool is_among(const std::vector<MemberId>& bars, MemberId bar) { return std::ranges::find(bars, bar) != bars.end(); }

/// Writes the equations of one part.
class PartEquations {
public:
    PartEquations(const Truss& truss, std::vector<bool> is_inside, const KnownForces& known)
        : truss_(truss), is_inside_(std::move(is_inside)), known_(known)
    {
        for (std::size_t i = 0; i < truss.bars.size(); ++i) {
            const auto& [a, b] = truss.bars[i].joints;
            if (is_inside_[a.index] == is_inside_[b.index]) continue;
            (known[i] ? known_bars_ : unknown_bars_).emplace_back(i);
        }
        for (const Eigen::Vector2d& joint : truss.joints) size_ = std::max(size_, (joint - truss.joints[0]).norm());
    }

    std::optional<CutEquation> equation(MemberId bar) const
    {
        CutEquation equation{.bar = bar};
        if (!set_point(equation)) return std::nullopt;
        equation.factor = factor(equation, joint_inside(bar), outward(bar));
        if (std::abs(equation.factor) <= negligible_arm * (equation.ritter_point ? size_ : 1.0)) return std::nullopt;
        double sum = 0.0;
        for (const Share& share : shares(equation)) {
            sum += share.size * share.factor;
            equation.shares.push_back(share);
        }
        equation.force = -sum / equation.factor;
        if (truss_.is_zero(equation.force)) equation.force = 0.0;
        return equation;
    }

    const std::vector<MemberId>& known_bars() const { return known_bars_; }

private:
    NodeId joint_inside(MemberId bar) const
    {
        const auto& joints = truss_[bar].joints;
        return is_inside_[joints[0].index] ? joints[0] : joints[1];
    }
    /// The way in which a bar in tension pulls the part.
    Eigen::Vector2d outward(MemberId bar) const { return truss_.away_from(joint_inside(bar), bar); }

    /// Where the other unknown bars meet, or across them; false if they do neither.
    bool set_point(CutEquation& equation) const
    {
        std::vector<MemberId> others = unknown_bars_;
        std::erase(others, equation.bar);
        if (others.empty()) {
            equation.across = outward(equation.bar);
            return true;
        }
        const Eigen::Vector2d first = outward(others[0]), at = truss_.joints[joint_inside(others[0]).index];
        for (const MemberId other : others) {
            const Eigen::Vector2d direction = outward(other);
            if (truss_.are_parallel(first, direction)) continue;
            const Eigen::Vector2d to = truss_.joints[joint_inside(other).index] - at;
            equation.ritter_point = at + cross_product(to, direction) / cross_product(first, direction) * first;
            break;
        }
        if (others.size() == 1) equation.ritter_point = joint_off(equation.bar, others[0]);
        if (!equation.ritter_point) equation.across = Eigen::Vector2d(-first.y(), first.x());
        return std::ranges::all_of(others, [&](MemberId other) { return is_left_out(equation, other); });
    }

    /// Of one other bar either joint will do that does not lie on the line of the bar that is sought.
    Eigen::Vector2d joint_off(MemberId bar, MemberId other) const
    {
        const Eigen::Vector2d at = truss_.joints[joint_inside(bar).index];
        const Eigen::Vector2d inside = truss_.joints[joint_inside(other).index];
        const bool is_off = std::abs(cross_product(outward(bar), inside - at)) > negligible_arm * size_;
        return is_off ? inside : truss_.joints[truss_.other_joint(other, joint_inside(other)).index];
    }

    bool is_left_out(const CutEquation& equation, MemberId other) const
    {
        const double size = equation.ritter_point ? size_ : 1.0;
        return std::abs(factor(equation, joint_inside(other), outward(other))) <= negligible_arm * size;
    }

    double factor(const CutEquation& equation, NodeId joint, const Eigen::Vector2d& direction) const
    {
        if (!equation.ritter_point) return equation.across.dot(direction);
        return cross_product(truss_.joints[joint.index] - *equation.ritter_point, direction);
    }

    std::vector<Share> shares(const CutEquation& equation) const
    {
        std::vector<Share> all;
        for (std::size_t i = 0; i < truss_.forces.size(); ++i) {
            const ExternalForce& force = truss_.forces[i];
            if (!is_inside_[force.joint.index]) continue;
            all.push_back({.force = i,
                           .bar = {},
                           .size = force.force.norm(),
                           .factor = factor(equation, force.joint, force.force.normalized())});
        }
        for (const MemberId bar : known_bars_)
            all.push_back({.force = {},
                           .bar = bar,
                           .size = *known_[bar.index],
                           .factor = factor(equation, joint_inside(bar), outward(bar))});
        std::erase_if(all, [&](const Share& share) {
            return share.size == 0.0 ||
                   std::abs(share.factor) <= negligible_arm * (equation.ritter_point ? size_ : 1.0);
        });
        return all;
    }

    const Truss& truss_;
    std::vector<bool> is_inside_;
    const KnownForces& known_;
    std::vector<MemberId> known_bars_, unknown_bars_;
    double size_ = 0.0;
};

/// The two sides of a cut: which joints lie on the first. Nothing if a bar of it joins joints of one side.
std::optional<std::vector<bool>> sides_of(const Truss& truss, const std::vector<MemberId>& bars)
{
    const std::vector<int> part = parts_of(truss, [&](MemberId bar) { return !is_among(bars, bar); });
    std::vector<int> side(part.size(), no_part); // of each part
    for (std::size_t round = 0; round < bars.size(); ++round)
        for (const MemberId bar : bars) {
            int& a = side[static_cast<std::size_t>(part[truss[bar].joints[0].index])];
            int& b = side[static_cast<std::size_t>(part[truss[bar].joints[1].index])];
            if (&a == &b || (a != no_part && a == b)) return std::nullopt;
            if (a == no_part && b == no_part && round == 0 && bar == bars.front()) a = 0;
            if (a != no_part && b == no_part) b = 1 - a;
            if (b != no_part && a == no_part) a = 1 - b;
        }
    std::vector<bool> is_first(part.size(), false);
    for (std::size_t i = 0; i < part.size(); ++i)
        is_first[i] = part[i] != no_part && side[static_cast<std::size_t>(part[i])] == 0;
    return is_first;
}

/// Of a part the joints of the other.
std::vector<bool> opposite(const Truss& truss, const std::vector<bool>& is_first)
{
    std::vector<bool> is_second(is_first.size(), false);
    for (std::size_t i = 0; i < is_first.size(); ++i) is_second[i] = !is_first[i] && !truss.bars_at[i].empty();
    return is_second;
}

/// Few forces make short equations.
std::vector<bool> better_side(const Truss& truss, const std::vector<bool>& is_first)
{
    const std::vector<bool> is_second = opposite(truss, is_first);
    const auto n_forces = [&](const std::vector<bool>& is_inside) {
        return std::ranges::count_if(truss.forces, [&](const auto& force) { return is_inside[force.joint.index]; });
    };
    const auto left = [&](const std::vector<bool>& is_inside) {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < is_inside.size(); ++i)
            if (is_inside[i]) least = std::min(least, truss.joints[i].x());
        return least;
    };
    const auto first = n_forces(is_first), second = n_forces(is_second);
    if (first != second) return first < second ? is_first : is_second;
    return left(is_first) <= left(is_second) ? is_first : is_second;
}

RitterCut written(const Truss& truss, std::vector<MemberId> bars, const std::vector<bool>& is_inside,
                  const KnownForces& known)
{
    RitterCut cut{.bars = std::move(bars)};
    for (std::size_t i = 0; i < is_inside.size(); ++i)
        if (is_inside[i]) cut.part.emplace_back(i);
    const PartEquations equations(truss, is_inside, known);
    cut.known = equations.known_bars();
    for (const MemberId bar : cut.bars)
        if (auto equation = equations.equation(bar)) cut.equations.push_back(std::move(*equation));
    return cut;
}

/// Bars without which a part of what hangs together by unknown bars would fall apart.
class Bridges {
public:
    template <class IsKept>
    Bridges(const Truss& truss, const IsKept& is_kept)
        : truss_(truss), order_(truss.joints.size(), no_part), low_(order_)
    {
        for (std::size_t i = 0; i < truss.joints.size(); ++i)
            if (order_[i] == no_part) visit(NodeId(i), std::nullopt, is_kept);
    }
    const std::vector<MemberId>& all() const { return bridges_; }

private:
    template <class IsKept> void visit(NodeId joint, std::optional<MemberId> from, const IsKept& is_kept)
    {
        order_[joint.index] = low_[joint.index] = n_++;
        for (const MemberId bar : truss_.bars_at[joint.index]) {
            if (bar == from || !is_kept(bar)) continue;
            const NodeId other = truss_.other_joint(bar, joint);
            if (order_[other.index] == no_part) {
                visit(other, bar, is_kept);
                if (low_[other.index] > order_[joint.index]) bridges_.push_back(bar);
            }
            low_[joint.index] = std::min(low_[joint.index], low_[other.index]);
        }
    }

    const Truss& truss_;
    std::vector<int> order_, low_;
    std::vector<MemberId> bridges_;
    int n_ = 0;
};

/// The joints on one side of a bridge.
std::vector<bool> side_of_bridge(const Truss& truss, MemberId bridge, const std::vector<MemberId>& bars)
{
    const std::vector<int> part = parts_of(truss, [&](MemberId bar) { return is_among(bars, bar) && bar != bridge; });
    std::vector<bool> is_inside(part.size(), false);
    for (std::size_t i = 0; i < part.size(); ++i) is_inside[i] = part[i] == part[truss[bridge].joints[0].index];
    return is_inside;
}

/// Of sections that find the first of their bars the one that a person would take.
class EasiestCut {
public:
    EasiestCut(const Truss& truss, const KnownForces& known) : truss_(truss), known_(known) {}

    void offer(const std::vector<MemberId>& bars, const std::vector<bool>& is_first)
    {
        const std::vector<bool> better = better_side(truss_, is_first);
        for (const std::vector<bool>& is_inside : {better, opposite(truss_, better)}) {
            const PartEquations equations(truss_, is_inside, known_);
            const auto found = equations.equation(bars.front());
            if (!found) continue;
            const std::ptrdiff_t n_joints = std::ranges::count(is_inside, true);
            const Effort effort{equations.known_bars().size(), n_joints == 1, joints_left_closed(bars.front()),
                                found->shares.size(), n_joints};
            if (!easiest_.empty() && effort_ <= effort) continue;
            effort_ = effort;
            easiest_ = bars;
            is_inside_ = is_inside;
        }
    }
    std::optional<RitterCut> cut() const
    {
        if (easiest_.empty()) return std::nullopt;
        return written(truss_, easiest_, is_inside_, known_);
    }

private:
    /// Bars of the cut that are known already, whether it goes around one joint, ends of the bar that is found whose other
    /// bars two equations do not find, terms of the equation, joints of the part.
    using Effort = std::tuple<std::size_t, bool, std::ptrdiff_t, std::size_t, std::ptrdiff_t>;

    std::ptrdiff_t joints_left_closed(MemberId bar) const
    {
        return std::ranges::count_if(truss_[bar].joints, [&](NodeId joint) {
            return std::ranges::count_if(truss_.bars_at[joint.index],
                                         [&](MemberId other) { return other != bar && !known_[other.index]; }) > 2;
        });
    }

    const Truss& truss_;
    const KnownForces& known_;
    std::vector<MemberId> easiest_;
    std::vector<bool> is_inside_;
    Effort effort_;
};

} // namespace

std::optional<Refusal> why_no_cut(const Truss& truss, const std::vector<MemberId>& bars)
{
    if (bars.size() < 2) return Refusal{.kind = RefusalKind::CutTooSmall, .bars = bars};
    const std::vector<int> part = parts_of(truss, [&](MemberId bar) { return !is_among(bars, bar); });
    const std::vector<int> whole = parts_of(truss, [](MemberId) { return true; });
    if (std::ranges::max(part) == std::ranges::max(whole))
        return Refusal{.kind = RefusalKind::CutNotThrough, .bars = bars};
    for (const MemberId bar : bars)
        if (part[truss[bar].joints[0].index] == part[truss[bar].joints[1].index])
            return Refusal{.kind = RefusalKind::CutAtOneSide, .bars = {bar}};
    if (!sides_of(truss, bars)) return Refusal{.kind = RefusalKind::CutAtOneSide, .bars = bars};
    if (ritter_cut(truss, bars).equations.empty()) return Refusal{.kind = RefusalKind::CutConcurrent, .bars = bars};
    return std::nullopt;
}

RitterCut ritter_cut(const Truss& truss, const std::vector<MemberId>& bars)
{
    return written(truss, bars, better_side(truss, *sides_of(truss, bars)), KnownForces(truss.bars.size()));
}

std::optional<RitterCut> cut_through_unknown(const Truss& truss, const KnownForces& known)
{
    std::vector<MemberId> unknown;
    for (std::size_t i = 0; i < truss.bars.size(); ++i)
        if (!known[i]) unknown.emplace_back(i);
    EasiestCut easiest(truss, known);
    for (std::size_t i = 0; i < unknown.size(); ++i)
        for (std::size_t j = i + 1; j < unknown.size(); ++j) {
            std::vector<MemberId> kept = unknown;
            std::erase(kept, unknown[i]);
            std::erase(kept, unknown[j]);
            std::vector<bool> is_kept(truss.bars.size(), false);
            for (const MemberId bar : kept) is_kept[bar.index] = true;
            const Bridges bridges(truss, [&](MemberId bar) { return is_kept[bar.index]; });
            for (const MemberId bridge : bridges.all()) {
                const std::vector<MemberId> bars{bridge, unknown[i], unknown[j]};
                const auto sides = sides_of(truss, bars); // nothing where known bars hold the parts together
                easiest.offer(bars, sides ? *sides : side_of_bridge(truss, bridge, kept));
            }
        }
    return easiest.cut();
}

} // namespace femoop::truss
