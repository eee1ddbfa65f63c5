#pragma once

#include <cstddef>
#include <vector>

#include "femoop/methods/influence/train/position_function.h"
#include "femoop/methods/influence/train/train_search.h"

namespace femoop::influence {

/// The effect of the axles of a train that runs forwards, over the position of the leading one; spacings that vary
/// have the value that makes it largest.
///
/// Behind each spacing that varies begins a group of axles that keep their distances. With x the place of a group's
/// leading axle, its own effect is a function of x alone, and
///    largest of groups k, k+1, .. (x) = own effect(x) + max over the spacing g of largest of groups k+1, .. (x - l - g)
class TrainRun {
public:
    /// What the axles act on, and what else depends on where they stand: a function of the place `ahead` before the
    /// leading axle, and another of the place as far behind the last one.
    struct Ground {
        const PositionFunction* line = nullptr;
        const PositionFunction* covered = nullptr; ///< integral of the uniform load that a gap takes away, or nullptr
        double gap = 0.0;
        double shortest = 0.0; ///< PositionFunction
    };
    TrainRun(const Ground& ground, const MovingTrain& train);

    const PositionFunction& largest() const { return stages_.front(); }

    /// Is the effect a sum alone, so that the run on the line times -1 has the same effect times -1?
    bool is_linear() const { return groups_.size() == 1 && ground_.covered == nullptr; }
    TrainRun negated() const; ///< on the line times -1 \pre is_linear()

    /// The spacings with which the largest effect comes about; of several the least.
    std::vector<double> spacings(double position, Side side) const;

private:
    struct Group {
        std::vector<double> axles, offsets; ///< offsets of its axles behind its leading one
        double least = 0.0, most = 0.0;     ///< the spacing behind its last axle
    };
    TrainRun() = default;
    void part_into_groups(const MovingTrain& train);
    PositionFunction own_effect(std::size_t group) const;
    double following(std::size_t group, double x, double wanted) const;

    Ground ground_;
    std::vector<Group> groups_;
    std::vector<PositionFunction> own_;    ///< of each group but the last
    std::vector<PositionFunction> stages_; ///< of each with all behind it
};

} // namespace femoop::influence
