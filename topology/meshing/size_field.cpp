#include "topology/meshing/size_field.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace topology {

namespace {

constexpr std::uint32_t most_in_leaf = 8;

double distance_to(const FlatBox& box, const FlatPoint& place)
{
    const double x = std::max({box.low.x - place.x, 0.0, place.x - box.high.x});
    const double y = std::max({box.low.y - place.y, 0.0, place.y - box.high.y});
    return std::sqrt(x * x + y * y);
}

} // namespace

SizeField::SizeField(std::vector<Sample> samples, double growth) : samples_(std::move(samples)), growth_(growth)
{
    for (const Sample& sample : samples_) greatest_ = std::max(greatest_, sample.size);
    if (!samples_.empty()) make_box(0, static_cast<Index>(samples_.size()));
}

/// Halves across the longer side.
void SizeField::make_box(Index first, Index last)
{
    const auto number = static_cast<Index>(boxes_.size());
    SampleBox made{.first = first, .last = last};
    made.least = std::numeric_limits<double>::infinity();
    for (Index i = first; i < last; ++i) {
        made.box.add(samples_[i].at);
        made.least = std::min(made.least, samples_[i].size);
    }
    boxes_.push_back(made);
    if (last - first <= most_in_leaf) return;
    const bool is_wide = made.box.high.x - made.box.low.x >= made.box.high.y - made.box.low.y;
    const Index half = first + (last - first) / 2;
    std::nth_element(
        samples_.begin() + first, samples_.begin() + half, samples_.begin() + last,
        [is_wide](const Sample& a, const Sample& b) { return is_wide ? a.at.x < b.at.x : a.at.y < b.at.y; });
    make_box(first, half);
    boxes_[number].right = static_cast<Index>(boxes_.size());
    make_box(half, last);
}

/// No sample of the box wants less.
double SizeField::least_in(const SampleBox& box, const FlatPoint& place) const
{
    return box.least + growth_ * distance_to(box.box, place);
}

void SizeField::look_into(Index number, const FlatPoint& place, double& size) const
{
    const SampleBox& box = boxes_[number];
    if (least_in(box, place) >= size) return;
    if (box.right == 0) {
        for (Index i = box.first; i < box.last; ++i)
            size = std::min(size, samples_[i].size + growth_ * distance(place, samples_[i].at));
        return;
    }
    Index nearer = number + 1, other = box.right;
    if (least_in(boxes_[other], place) < least_in(boxes_[nearer], place)) std::swap(nearer, other);
    look_into(nearer, place, size);
    look_into(other, place, size);
}

double SizeField::at(const FlatPoint& place) const
{
    double size = std::numeric_limits<double>::infinity();
    if (!samples_.empty()) look_into(0, place, size);
    return size;
}

} // namespace topology
