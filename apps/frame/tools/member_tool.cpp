#include "apps/frame/tools/member_tool.h"

#include <utility>

#include "apps/frame/document/drawing.h"
#include "ui/canvas/click.h"
#include "ui/text/catalogue.h"

namespace frame {

using Eigen::Vector2d;
using femoop::Crossings;

std::optional<Change> MemberTool::press(const Work&, const Aim& at)
{
    const Vector2d& place = at.snap.place;
    pointer_ = place;
    if (ends_at(at)) {
        start_.reset();
        return std::nullopt;
    }
    if (start_) return draw_to(place, at.crossings());
    start_ = place;
    press_ = at;
    return std::nullopt;
}

// The second click at one place ends the line; nobody means a member of a few pixels.
bool MemberTool::ends_at(const Aim& at) const
{
    return start_ && (at.snap.place - *start_).norm() <= ui::click_reach * at.pixel;
}

std::optional<Change> MemberTool::move(const Work&, const Aim& to)
{
    pointer_ = to.snap.place;
    return std::nullopt;
}

std::optional<Change> MemberTool::release(const Work&, const Aim& at)
{
    const std::optional<Aim> press = std::exchange(press_, std::nullopt);
    const bool was_dragged = press && at.is_dragged_from(*press);
    if (!was_dragged || !start_ || ends_at(at)) return std::nullopt;
    std::optional<Change> change = draw_to(at.snap.place, at.crossings());
    start_.reset();
    return change;
}

std::optional<Change> MemberTool::type(const Work&, const Vector2d& place)
{
    if (start_ && *start_ != place) return draw_to(place, Crossings::Cut);
    start_ = place;
    return std::nullopt;
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

std::optional<Change> MemberTool::draw_to(const Vector2d& place, Crossings crossings)
{
    const Vector2d start = *std::exchange(start_, place);
    return Change{ui::translatable("Draw a member"),
                  [start, place, crossings](Document& document) { draw_member(document, start, place, crossings); }};
}

} // namespace frame
