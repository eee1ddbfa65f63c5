#include "femoop/methods/influence/train/train_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace femoop::influence {

namespace {

using Trial = PositionFunction::Candidate;

constexpr double one_value = 1e-12; ///< of the largest magnitude: values that are one

} // namespace

TrainRun::TrainRun(const Ground& ground, const MovingTrain& train) : ground_(ground)
{
    part_into_groups(train);
    const std::size_t last = groups_.size() - 1;
    for (std::size_t k = 0; k < last; ++k) own_.push_back(own_effect(k));
    stages_.resize(groups_.size());
    stages_[last] = own_effect(last);
    for (std::size_t k = last; k-- > 0;) {
        const Group& group = groups_[k];
        const double length = group.offsets.back();
        const PositionFunction behind = stages_[k + 1].largest_within(length + group.least, length + group.most,
                                                                      ground_.shortest);
        stages_[k] = PositionFunction::sum({{&own_[k], 1.0, 0.0}, {&behind, 1.0, 0.0}}, ground_.shortest);
    }
}

TrainRun TrainRun::negated() const
{
    TrainRun opposite;
    opposite.ground_.shortest = ground_.shortest;
    opposite.groups_ = groups_;
    opposite.stages_.push_back(stages_.front().negated());
    return opposite;
}

void TrainRun::part_into_groups(const MovingTrain& train)
{
    groups_.emplace_back();
    for (std::size_t i = 0; i < train.axles.size(); ++i) {
        const bool is_first = groups_.back().axles.empty();
        if (!is_first) {
            const auto [least, most] = train.spacings[i - 1];
            if (most - least > ground_.shortest) {
                groups_.back().least = least;
                groups_.back().most = most;
                groups_.emplace_back();
            }
        }
        Group& group = groups_.back();
        group.offsets.push_back(group.axles.empty() ? 0.0 : group.offsets.back() + train.spacings[i - 1].least);
        group.axles.push_back(train.axles[i]);
    }
}

PositionFunction TrainRun::own_effect(std::size_t k) const
{
    const Group& group = groups_[k];
    std::vector<PositionFunction::Term> terms;
    for (std::size_t i = 0; i < group.axles.size(); ++i)
        terms.push_back({ground_.line, group.axles[i], group.offsets[i]});
    if (ground_.covered != nullptr && k == 0) terms.push_back({ground_.covered, -1.0, -ground_.gap});
    if (ground_.covered != nullptr && k + 1 == groups_.size())
        terms.push_back({ground_.covered, 1.0, group.offsets.back() + ground_.gap});
    return PositionFunction::sum(terms, ground_.shortest);
}

std::vector<double> TrainRun::spacings(double position, Side side) const
{
    std::vector<double> spacings;
    double x = position;
    for (std::size_t k = 0; k < groups_.size(); ++k) {
        const Group& group = groups_[k];
        for (std::size_t i = 1; i < group.offsets.size(); ++i)
            spacings.push_back(group.offsets[i] - group.offsets[i - 1]);
        if (k + 1 == groups_.size()) break;
        const double wanted = stages_[k].value(x, side, ground_.shortest) - own_[k].value(x, side, ground_.shortest);
        const double next = following(k, x, wanted);
        spacings.push_back(std::clamp(x - group.offsets.back() - next, group.least, group.most));
        x = next;
    }
    return spacings;
}

/// Where the next group stands, so that it and all behind it add what is wanted: as near as possible.
double TrainRun::following(std::size_t k, double x, double wanted) const
{
    const Group& group = groups_[k];
    const PositionFunction& behind = stages_[k + 1];
    const double first = x - group.offsets.back() - group.most, last = x - group.offsets.back() - group.least;
    std::vector<std::array<double, 2>> places; // and what they miss
    for (const Side side : {Side::Before, Side::After})
        for (const double edge : {first, last})
            places.push_back({edge, std::abs(behind.value(edge, side, ground_.shortest) - wanted)});
    for (const Trial& candidate : behind.candidates())
        if (candidate.x > first && candidate.x < last)
            places.push_back({candidate.x, std::abs(candidate.value - wanted)});
    double least = std::numeric_limits<double>::infinity(), nearest = first;
    for (const auto& [place, missed] : places) least = std::min(least, missed);
    const double margin = least + one_value * behind.largest_magnitude();
    for (const auto& [place, missed] : places)
        if (missed <= margin) nearest = std::max(nearest, place);
    return nearest;
}

} // namespace femoop::influence
