#include "apps/frame/tools/member_tool.h"

#include <utility>

#include "apps/frame/document/drawing.h"
#include "ui/canvas/click.h"
#include "ui/text/catalogue.h"

namespace frame {

using Eigen::Vector2d;
using Eigen::Vector3d;
using femoop::Crossings;

std::optional<Change> MemberTool::press(const Work&, const Aim& at)
{
    if (at.is_lost) return std::nullopt;
    const Vector3d place = at.place();
    pointer_ = place;
    if (ends_at(at)) {
        start_.reset();
        return std::nullopt;
    }
    click_ = at;
    if (start_) return draw_to(place, at.crossings());
    start_ = place;
    press_ = at;
    return std::nullopt;
}

// The second click at one place ends the line; nobody means a member of a few pixels.
bool MemberTool::ends_at(const Aim& at) const
{
    return start_ && (is_clicked_again(at) || (at.place() - *start_).norm() <= ui::click_reach * at.pixel);
}

// Where the hand was, whatever the places were drawn to: the first to the grid, the second to the member that came.
bool MemberTool::is_clicked_again(const Aim& at) const
{
    constexpr double reach = 2.0 * ui::click_reach; // two clicks lie farther apart than a press and its release
    if (!click_ || distance(at.on_sheet, click_->on_sheet) > reach) return false;
    return distance(at.projection(*start_), click_->projection(*start_)) <= ui::click_reach; // the picture has rested
}

std::optional<Change> MemberTool::move(const Work&, const Aim& to)
{
    if (!to.is_lost) pointer_ = to.place();
    return std::nullopt;
}

std::optional<Change> MemberTool::release(const Work&, const Aim& at)
{
    const std::optional<Aim> press = std::exchange(press_, std::nullopt);
    const bool was_dragged = press && at.is_dragged_from(*press);
    if (!was_dragged || !start_ || at.is_lost || ends_at(at)) return std::nullopt;
    std::optional<Change> change = draw_to(at.place(), at.crossings());
    start_.reset();
    return change;
}

std::optional<Change> MemberTool::type(const Work& work, const Vector2d& place)
{
    return type_in_space(work, {place.x(), place.y(), 0.0});
}

std::optional<Change> MemberTool::type_in_space(const Work&, const Vector3d& place)
{
    click_.reset();
    if (start_ && *start_ != place) return draw_to(place, Crossings::Cut);
    start_ = place;
    return std::nullopt;
}

std::optional<Vector2d> MemberTool::from() const
{
    return start_ ? std::optional<Vector2d>(start_->head<2>()) : std::nullopt;
}

bool MemberTool::escape()
{
    press_.reset();
    const bool had_begun = start_.has_value();
    start_.reset();
    return had_begun;
}

Preview MemberTool::preview() const
{
    if (!start_ || *start_ == pointer_) return {};
    return {.lines = {{*start_, pointer_}}};
}

std::optional<Change> MemberTool::draw_to(const Vector3d& place, Crossings crossings)
{
    const Vector3d start = *std::exchange(start_, place);
    return Change{ui::translatable("Draw a member"), [start, place, crossings](Document& document) {
                      draw_member_in_space(document, start, place, crossings);
                  }};
}

} // namespace frame
