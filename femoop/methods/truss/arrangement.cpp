#include "femoop/methods/truss/arrangement.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "femoop/geometry/plane_vectors.h"

namespace femoop::truss {

namespace {

constexpr double along_bar = 1e-9;    // rad: so near a bar a line runs along it
constexpr double clear_of_bars = 0.5; // rad: an arrow is well seen there

/// Between a bar and the next one clockwise.
struct Corner {
    Eigen::Vector2d begin;
    double angle = 0.0;

    bool holds(const Eigen::Vector2d& direction) const
    {
        const double at = clockwise_angle(begin, direction);
        return at > along_bar && at < angle - along_bar;
    }
    Eigen::Vector2d middle() const
    {
        const double half = 0.5 * angle;
        return {begin.x() * std::cos(half) + begin.y() * std::sin(half),
                begin.y() * std::cos(half) - begin.x() * std::sin(half)};
    }
};

/// Lays out what meets one joint.
class JointArranger {
public:
    JointArranger(const Truss& truss, NodeId joint, const IsOpen& is_open)
        : truss_(truss), joint_(joint), bars_(clockwise_bars(truss, joint))
    {
        for (std::size_t i = 0; i < bars_.size(); ++i) {
            const Eigen::Vector2d begin = truss.away_from(joint, bars_[i]);
            const Eigen::Vector2d end = truss.away_from(joint, bars_[(i + 1) % bars_.size()]);
            corners_.push_back({begin, clockwise_angle(begin, end)});
            is_open_.push_back(is_open(joint, bars_[i]));
        }
        forces_in_.resize(bars_.size());
    }

    std::vector<Spoke> arranged()
    {
        for (std::size_t i = 0; i < truss_.forces.size(); ++i)
            if (truss_.forces[i].joint == joint_) lay(i);
        std::vector<Spoke> spokes;
        for (std::size_t i = 0; i < bars_.size(); ++i) {
            spokes.push_back({.bar = bars_[i], .force = {}, .away = corners_[i].begin});
            std::ranges::stable_sort(
                forces_in_[i], {}, [&](const Spoke& spoke) { return clockwise_angle(corners_[i].begin, spoke.away); });
            std::ranges::copy(forces_in_[i], std::back_inserter(spokes));
        }
        return spokes;
    }

private:
    /// A direction between two bars, and the angle to the nearer one.
    struct Place {
        std::size_t corner = 0;
        Eigen::Vector2d away;
        double room = 0.0;
    };

    void lay(std::size_t force)
    {
        const Eigen::Vector2d along = truss_.forces[force].force.normalized();
        const std::optional<Place> pushing = place(-along), pulling = place(along);
        if (pushing && (pushing->room >= clear_of_bars || !pulling || pushing->room >= pulling->room))
            return lay(force, *pushing);
        if (pulling) return lay(force, *pulling);
        if (const auto widest = widest_open()) lay(force, {*widest, corners_[*widest].middle(), 0.0});
    }

    void lay(std::size_t force, const Place& place)
    {
        forces_in_[place.corner].push_back({.bar = {}, .force = force, .away = place.away});
    }

    std::optional<Place> place(const Eigen::Vector2d& away) const
    {
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            if (!is_open_[i] || !corners_[i].holds(away)) continue;
            const double at = clockwise_angle(corners_[i].begin, away);
            return Place{i, away, std::min(at, corners_[i].angle - at)};
        }
        return std::nullopt;
    }

    std::optional<std::size_t> widest_open() const
    {
        std::optional<std::size_t> widest;
        for (std::size_t i = 0; i < corners_.size(); ++i)
            if (is_open_[i] && (!widest || corners_[i].angle > corners_[*widest].angle)) widest = i;
        return widest;
    }

    const Truss& truss_;
    NodeId joint_;
    std::vector<MemberId> bars_;
    std::vector<Corner> corners_;
    std::vector<bool> is_open_;
    std::vector<std::vector<Spoke>> forces_in_;
};

} // namespace

double clockwise_angle(const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
    const double angle = std::atan2(-cross_product(from, to), from.dot(to));
    return angle > 0.0 ? angle : angle + 2.0 * std::numbers::pi;
}

std::vector<MemberId> clockwise_bars(const Truss& truss, NodeId joint)
{
    std::vector<MemberId> bars = truss.bars_at[joint.index];
    std::ranges::sort(bars, std::ranges::greater{}, [&](MemberId bar) {
        const Eigen::Vector2d away = truss.away_from(joint, bar);
        return std::atan2(away.y(), away.x());
    });
    return bars;
}

Arrangement arrange(const Truss& truss, const IsOpen& is_open)
{
    Arrangement all;
    for (std::size_t i = 0; i < truss.joints.size(); ++i)
        all.push_back(JointArranger(truss, NodeId(i), is_open).arranged());
    return all;
}

} // namespace femoop::truss
