#include "apps/frame/tools/free_body_tool.h"

#include <cmath>
#include <utility>

#include "apps/frame/free_body/asked_body.h"
#include "apps/frame/tools/snap.h"

namespace frame {

using Eigen::Vector3d;

namespace {

constexpr double reach = 9.0; // [px]

Vector3d pointer_in_plane(const Aim& at) { return {at.pointer.x(), at.pointer.y(), 0.0}; }

} // namespace

bool FreeBodyTool::is_at_moment_point(const AskedBody& body, const Aim& at)
{
    const drawing::FreeBodyPicture* const picture = body.last();
    return picture != nullptr && at.may_drag() &&
           (picture->moment_point() - pointer_in_plane(at)).norm() <= reach * at.pixel;
}

// To a Ritter point or the place of a force that is near, else to a round one; Alt takes the place as it is.
Vector3d FreeBodyTool::moment_point(const AskedBody& body, const Aim& at)
{
    const drawing::FreeBodyPicture& picture = *body.last();
    const Vector3d place = pointer_in_plane(at) - picture.aside;
    if (at.is_exact) return place;
    const auto is_near = [&](const Vector3d& other) { return (other - place).norm() <= reach * at.pixel; };
    for (const auto& point : picture.lifted.ritter_points)
        if (is_near(point.at)) return point.at;
    for (const auto& force : picture.lifted.forces)
        if (is_near(force.at)) return force.at;
    const double step = round_grid(4.0 * at.pixel);
    return {step * std::round(place.x() / step), step * std::round(place.y() / step), 0.0};
}

std::optional<Change> FreeBodyTool::press(const Work& work, const Aim& at)
{
    press_ = at;
    now_ = at.pointer;
    holds_moment_point_ = is_at_moment_point(*work.free_body, at);
    is_cutting_ = false;
    return std::nullopt;
}

std::optional<Change> FreeBodyTool::move(const Work& work, const Aim& to)
{
    if (!press_) return std::nullopt;
    now_ = to.pointer;
    if (holds_moment_point_ && work.free_body->last() != nullptr)
        work.free_body->put_moment_point(moment_point(*work.free_body, to));
    else is_cutting_ = is_cutting_ || (to.may_drag() && to.is_dragged_from(*press_));
    return std::nullopt;
}

std::optional<Change> FreeBodyTool::release(const Work& work, const Aim& at)
{
    const std::optional<Aim> press = std::exchange(press_, std::nullopt);
    if (!press || std::exchange(holds_moment_point_, false)) return std::nullopt;
    if (std::exchange(is_cutting_, false)) work.free_body->cut(work.document.model, {press->pointer, at.pointer});
    else lift(work, *press);
    return std::nullopt;
}

void FreeBodyTool::lift(const Work& work, const Aim& at)
{
    const femoop::Model& model = work.document.model;
    if (at.node) work.free_body->lift(model, *at.node);
    else if (at.cut) work.free_body->lift(model, at.cut->member, at.adds);
    else if (at.support) work.free_body->lift(model, at.support->node);
}

bool FreeBodyTool::escape()
{
    is_cutting_ = holds_moment_point_ = false;
    return std::exchange(press_, std::nullopt).has_value();
}

Preview FreeBodyTool::preview() const
{
    Preview preview;
    if (is_cutting_ && press_)
        preview.lines.emplace_back(Vector3d(press_->pointer.x(), press_->pointer.y(), 0.0),
                                   Vector3d(now_.x(), now_.y(), 0.0));
    return preview;
}

} // namespace frame
