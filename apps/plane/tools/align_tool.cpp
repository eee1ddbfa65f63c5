#include "apps/plane/tools/align_tool.h"

#include <utility>

namespace plane {

std::optional<Alignment> AlignTool::add(const FlatPoint& place)
{
    if (picks()) {
        if (picked_.empty() || picked_.front() != place) picked_.push_back(place);
        return std::nullopt;
    }
    if (first_target_) return add_second(place);
    first_target_ = place;
    return std::nullopt;
}

std::optional<Alignment> AlignTool::add_second(const FlatPoint& place)
{
    if (place == from()) return std::nullopt;
    const Alignment whole{.from = {picked_[0], picked_[1]}, .to = {from(), place}};
    *this = {};
    return whole;
}

std::optional<Alignment> AlignTool::finish() { return first_target_ ? add_second(towards()) : std::nullopt; }

bool AlignTool::escape()
{
    if (std::exchange(first_target_, std::nullopt)) return true;
    if (picked_.empty()) return false;
    picked_.pop_back();
    return true;
}

} // namespace plane
