#include "femoop/methods/truss/zero_force.h"

#include <algorithm>

namespace femoop::truss {

namespace {

/// Goes from joint to joint until no rule finds another bar.
class ZeroForceSearch {
public:
    explicit ZeroForceSearch(const Truss& truss) : truss_(truss), is_found_(truss.bars.size(), false) {}

    std::vector<ZeroForceBar> found() &&
    {
        while (look_once(false) || look_once(true)) {
        }
        for (std::size_t i = 0; i < truss_.bars.size(); ++i)
            if (!is_found_[i] && truss_.bars[i].force == 0.0)
                found_.push_back({.bar = MemberId(i), .joint = {}, .in_line = {}});
        return std::move(found_);
    }

private:
    /// Supported joints come last: there one has to know the reaction.
    bool look_once(bool are_supported)
    {
        const std::size_t before = found_.size();
        for (std::size_t i = 0; i < truss_.joints.size(); ++i)
            if (truss_.is_supported[i] == are_supported) look_at(NodeId(i));
        return found_.size() > before;
    }

    void look_at(NodeId joint)
    {
        std::vector<MemberId> bars;
        without_.clear();
        for (const MemberId bar : truss_.bars_at[joint.index]) (is_found_[bar.index] ? without_ : bars).push_back(bar);
        const Eigen::Vector2d force = truss_.force_at(joint);
        const bool is_unloaded = force.isZero(0.0);
        if (bars.size() == 1 && is_unloaded) add(bars[0], ZeroForceRule::SingleBar, joint);
        if (bars.size() == 2 && !are_in_line(joint, bars[0], bars[1])) look_at_two(joint, bars, force);
        if (bars.size() == 3) look_at_three(joint, bars, force);
    }

    void look_at_two(NodeId joint, const std::vector<MemberId>& bars, const Eigen::Vector2d& force)
    {
        if (force.isZero(0.0))
            for (const MemberId bar : bars) add(bar, ZeroForceRule::TwoBars, joint);
        else
            for (const std::size_t i : {0U, 1U})
                if (truss_.are_parallel(force, truss_[bars[i]].direction))
                    add(bars[1 - i], ZeroForceRule::ForceAlongBar, joint, bars[i]);
    }

    void look_at_three(NodeId joint, const std::vector<MemberId>& bars, const Eigen::Vector2d& force)
    {
        for (std::size_t third = 0; third < 3; ++third) {
            const MemberId a = bars[(third + 1) % 3], b = bars[(third + 2) % 3];
            if (!are_in_line(joint, a, b)) continue;
            if (force.isZero(0.0)) return add(bars[third], ZeroForceRule::ThirdBar, joint, a);
            if (truss_.are_parallel(force, truss_[a].direction))
                return add(bars[third], ZeroForceRule::ForceInLine, joint, a);
        }
    }

    bool are_in_line(NodeId joint, MemberId a, MemberId b) const
    {
        const Eigen::Vector2d away = truss_.away_from(joint, a), other = truss_.away_from(joint, b);
        return truss_.are_parallel(away, other) && away.dot(other) < 0.0;
    }

    void add(MemberId bar, ZeroForceRule rule, NodeId joint, std::optional<MemberId> in_line = std::nullopt)
    {
        is_found_[bar.index] = true;
        found_.push_back({.bar = bar, .rule = rule, .joint = joint, .in_line = in_line, .without = without_});
    }

    const Truss& truss_;
    std::vector<bool> is_found_;
    std::vector<MemberId> without_; ///< at the joint that is looked at
    std::vector<ZeroForceBar> found_;
};

} // namespace

std::vector<ZeroForceBar> zero_force_bars(const Truss& truss) { return ZeroForceSearch(truss).found(); }

std::vector<std::vector<ZeroForceBar>> zero_force_steps(const Truss& truss)
{
    std::vector<std::vector<ZeroForceBar>> steps;
    for (ZeroForceBar& bar : zero_force_bars(truss)) {
        const bool goes_on = !steps.empty() && steps.back().back().joint == bar.joint;
        if (!goes_on) steps.emplace_back();
        steps.back().push_back(std::move(bar));
    }
    return steps;
}

} // namespace femoop::truss
