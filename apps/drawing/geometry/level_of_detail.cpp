#include "apps/drawing/geometry/level_of_detail.h"

#include <algorithm>
#include <vector>

namespace drawing {

namespace {

constexpr double ample_length = 36.0; // [px] of a member on which whole symbols have room
constexpr double least_share = 0.5;

} // namespace

LevelOfDetail::LevelOfDetail(const StructureShape& shape, const Projection& projection)
{
    if (shape.members.empty()) return;
    std::vector<double> lengths;
    lengths.reserve(shape.members.size());
    for (const MemberShape& member : shape.members)
        lengths.push_back(ui::distance(projection(member.start), projection(member.end)));
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    median_length_ = *middle;
}

double LevelOfDetail::symbol_share() const
{
    return median_length_ > 0.0 ? std::clamp(median_length_ / ample_length, least_share, 1.0) : 1.0;
}

} // namespace drawing
