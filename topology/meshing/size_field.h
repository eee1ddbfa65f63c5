#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "topology/geometry/flat_point.h"

namespace topology {

/// Of sizes by the distance from smaller ones.
inline constexpr double usual_growth = 0.3;

/// How long edges are wanted at every place of a plane: at some places as they say, from there on growing with the
/// distance, so that no element is much larger than its neighbour. With sizes h_i at places x_i
///
///     h(x) = min over i of (h_i + growth |x - x_i|)
///
/// Units     lengths; the growth is a length by a length
/// Accuracy  exact; a place is answered in about log n by a tree of boxes
class SizeField {
public:
    struct Sample {
        FlatPoint at;
        double size = 0.0; ///< above 0
    };

    SizeField() = default;
    SizeField(std::vector<Sample> samples, double growth);

    double at(const FlatPoint& place) const; ///< infinite where there are no samples
    bool is_empty() const { return samples_.empty(); }
    double least() const { return is_empty() ? std::numeric_limits<double>::infinity() : boxes_.front().least; }
    double greatest() const { return greatest_; } ///< of the samples; 0 where there are none
    const std::vector<Sample>& samples() const { return samples_; }
    double growth() const { return growth_; }

private:
    using Index = std::uint32_t;
    /// Samples from first to last, the latter left out, what they reach and the least size among them.
    struct SampleBox {
        FlatBox box;
        double least = 0.0;
        Index first = 0, last = 0;
        Index right = 0; ///< 0: no halves; the left one is the next box
    };
    void make_box(Index first, Index last);
    double least_in(const SampleBox& box, const FlatPoint& place) const;
    void look_into(Index box, const FlatPoint& place, double& size) const;

    std::vector<Sample> samples_;
    std::vector<SampleBox> boxes_; ///< the one of all first
    double growth_ = 0.0, greatest_ = 0.0;
};

} // namespace topology
