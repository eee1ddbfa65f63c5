#include "apps/frame/tools/funicular_tool.h"

#include <cmath>
#include <utility>

#include "apps/frame/tools/snap.h"

namespace frame {

using drawing::FunicularHandle;
using drawing::FunicularPicture;

namespace {

constexpr double hand_reach = 9.0; // [px]

double round_place(double value, const Aim& at)
{
    const double step = round_grid(4.0 * at.pixel);
    return step * std::round(value / step);
}

/// Where the rise stands as the line passes through the crown of the chain.
std::optional<double> height_through_crown(const FunicularPicture& picture)
{
    const auto& span = picture.funicular.span;
    const auto closing_line = picture.funicular.closing_line;
    const auto crown = picture.chain.crown();
    const auto H = crown ? thrust_through(span, closing_line, *crown) : std::nullopt;
    if (!H) return std::nullopt;
    return femoop::funicular::Funicular{span, closing_line, *H}.height(span.largest_moment().x);
}

} // namespace

std::optional<FunicularHandle> FunicularTool::handle_at(const FunicularPicture& picture, const Aim& at)
{
    if (!at.may_drag()) return std::nullopt;
    std::optional<FunicularHandle> nearest;
    double reach = hand_reach * at.pixel;
    for (const FunicularHandle handle : drawing::funicular_handles) {
        const double off = (picture.place_of(handle).head<2>() - at.pointer).norm();
        if (off > reach) continue;
        reach = off;
        nearest = handle;
    }
    return nearest;
}

// Alt takes the height as it is.
double FunicularTool::height_for(const FunicularPicture& picture, FunicularHandle handle, const Aim& at)
{
    const double height = at.pointer.y();
    if (at.is_exact) return height;
    std::optional<double> wanted;
    if (handle == FunicularHandle::LeftEnd) wanted = picture.chain.left().y();
    else if (handle == FunicularHandle::RightEnd) wanted = picture.chain.right().y();
    else wanted = height_through_crown(picture);
    const bool is_near = wanted && std::abs(*wanted - height) <= hand_reach * at.pixel;
    return is_near ? *wanted : round_place(height, at);
}

// To a node of the chain or the largest moment that is near, else to a round place.
std::optional<double> FunicularTool::place_read(const FunicularPicture& picture, const Aim& at)
{
    const double x = at.pointer.x(), reach = hand_reach * at.pixel;
    const auto& span = picture.funicular.span;
    if (!at.may_drag() || x < span.from() - reach || x > span.to() + reach) return std::nullopt;
    if (at.is_exact) return x;
    for (const Eigen::Vector2d& place : picture.chain.axis)
        if (std::abs(place.x() - x) <= reach) return place.x();
    const double largest = span.largest_moment().x;
    return std::abs(largest - x) <= reach ? largest : round_place(x, at);
}

std::optional<Change> FunicularTool::press(const Work& work, const Aim& at)
{
    press_ = at;
    const FunicularPicture* const picture = work.funicular->last();
    held_ = picture != nullptr ? handle_at(*picture, at) : std::nullopt;
    pressed_ = work.funicular;
    before_ = *pressed_;
    return std::nullopt;
}

std::optional<Change> FunicularTool::move(const Work& work, const Aim& to)
{
    const FunicularPicture* const picture = work.funicular->last();
    if (picture == nullptr) return std::nullopt;
    if (!press_) work.funicular->reach_for(handle_at(*picture, to));
    if (!held_) work.funicular->read_at(place_read(*picture, to));
    else if (press_ && to.is_dragged_from(*press_)) work.funicular->drag(*held_, height_for(*picture, *held_, to));
    return std::nullopt;
}

std::optional<Change> FunicularTool::release(const Work& work, const Aim&)
{
    const std::optional<Aim> press = std::exchange(press_, std::nullopt);
    pressed_ = nullptr;
    if (!press || std::exchange(held_, std::nullopt) || !press->cut) return std::nullopt;
    work.funicular->pick(work.document.model, press->cut->member, press->adds);
    return std::nullopt;
}

bool FunicularTool::escape()
{
    if (!press_) return false;
    *std::exchange(pressed_, nullptr) = before_;
    held_.reset();
    press_.reset();
    return true;
}

} // namespace frame
