#include "apps/frame/tools/predict_tool.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "apps/drawing/results/influence_picture.h"
#include "femoop/geometry/member_axes.h"
#include "femoop/geometry/member_geometry.h"

namespace frame {

using Eigen::Vector2d;
using Eigen::Vector3d;
using femoop::MemberId;

Vector2d PencilView::pointer(const Aim& at) const
{
    return seen_ ? Vector2d(at.on_sheet.x, at.on_sheet.y) : at.pointer;
}

Vector2d PencilView::place(const Vector3d& in_space) const
{
    if (!seen_) return in_space.head<2>();
    const ui::Point at = (*seen_)(in_space);
    return {at.x, at.y};
}

Vector2d PencilView::direction(const Vector3d& unit) const
{
    if (!seen_) return unit.head<2>();
    const ui::Point image = seen_->scale() * seen_->direction(unit);
    return {image.x, image.y};
}

std::optional<Change> PredictTool::press(const Work& work, const Aim& at)
{
    path_.clear();
    press_ = at;
    view_ = PencilView::of(at);
    is_drawing_ = false;
    if (work.prediction != nullptr) path_.push_back(view_.pointer(at));
    return std::nullopt;
}

std::optional<Change> PredictTool::move(const Work& work, const Aim& to)
{
    const PencilView view = path_.empty() ? PencilView::of(to) : view_;
    const double step = view.scale() * to.pixel;
    if (!path_.empty() && (view.pointer(to) - path_.back()).norm() >= step) path_.push_back(view.pointer(to));
    is_drawing_ = is_drawing_ || to.is_dragged_from(press_);
    const std::vector<Vector2d> seen = path_.empty() ? std::vector<Vector2d>{view.pointer(to)} : path_;
    member_ = work.prediction != nullptr ? member_beside(work.document.model, sketched_members(work), seen, view)
                                         : std::nullopt;
    return std::nullopt;
}

bool PredictTool::takes_hold(const Work& work, const Aim& at) const
{
    if (work.prediction == nullptr || work.sketched_line == nullptr || at.adds) return false;
    const PencilView view = PencilView::of(at);
    if (!shows_ordinates(work.document.model, *work.sketched_line, view)) return false;
    const std::vector<Vector2d> here{view.pointer(at)};
    return member_beside(work.document.model, sketched_members(work), here, view).has_value();
}

namespace {

double distance_to(const Vector2d& a, const Vector2d& b, const Vector2d& place)
{
    const Vector2d along = b - a;
    const double squared = along.squaredNorm(); // 0 of a member that is seen end-on
    const double t = squared > 0.0 ? std::clamp((place - a).dot(along) / squared, 0.0, 1.0) : 0.0;
    return (a + t * along - place).norm();
}

/// Of the path's members it is the one that some place of the stroke is nearest to.
bool is_nearest_somewhere(const femoop::Model& model, const femoop::influence::PathLayout& path, MemberId member,
                          std::span<const Vector2d> stroke, const PencilView& view)
{
    const auto distance = [&](MemberId other, const Vector2d& place) {
        const femoop::MemberGeometry ends = femoop::geometry_of(model, model[other]);
        return distance_to(view.place(ends.start), view.place(ends.end), place);
    };
    return std::ranges::any_of(stroke, [&](const Vector2d& place) {
        const double own = distance(member, place);
        return std::ranges::all_of(path.members, [&](const auto& on) { return own <= distance(on.member, place); });
    });
}

/// How much of a member's length a stroke passes.
double share_passed(std::span<const StrokePoint> stroke)
{
    double least = 1.0, most = 0.0;
    for (const StrokePoint& point : stroke) {
        least = std::min(least, std::clamp(point.x, 0.0, 1.0));
        most = std::max(most, std::clamp(point.x, 0.0, 1.0));
    }
    return most - least;
}

// Along the path in one stroke: each member has the part that runs beside it, but for a bit that slipped over a node.
void sketch_line(const Work& work, MemberId nearest, std::span<const Vector2d> path, const PencilView& view)
{
    constexpr double clearly = 0.2;
    const femoop::Model& model = work.document.model;
    const drawing::InfluencePicture& asked = *work.sketched_line;
    for (const auto& on : asked.path.members) {
        const femoop::MemberGeometry line = femoop::geometry_of(model, model[on.member]);
        if (!(line.length > 0.0)) continue;
        const auto along = stroke_along(line, drawing::ordinate_side(asked.load, line, view.is_flat()), path, view);
        const bool is_beside = on.member == nearest || (share_passed(along) > clearly &&
                                                        is_nearest_somewhere(model, asked.path, on.member, path, view));
        if (is_beside) work.prediction->draw(model, asked.line.effect, on.member, along);
    }
}

} // namespace

std::optional<Change> PredictTool::release(const Work& work, const Aim&)
{
    const std::vector<Vector2d> path = std::exchange(path_, {});
    const femoop::Model& model = work.document.model;
    const auto member = member_beside(model, sketched_members(work), path, view_);
    if (work.prediction == nullptr || !member || !is_drawing_) return std::nullopt;
    if (work.sketched_line != nullptr) {
        sketch_line(work, *member, path, view_);
        return std::nullopt;
    }
    const femoop::MemberGeometry line = femoop::geometry_of(model, model[*member]);
    work.prediction->draw(model, settings_.load_case, *member,
                          stroke_along(line, moment_side(line, settings_.moment_side), path));
    return std::nullopt;
}

bool PredictTool::escape() { return !std::exchange(path_, {}).empty(); }

namespace {

double mean_distance(const femoop::MemberGeometry& ends, std::span<const Vector2d> path, const PencilView& view)
{
    double sum = 0.0;
    for (const Vector2d& place : path) sum += distance_to(view.place(ends.start), view.place(ends.end), place);
    return sum / static_cast<double>(path.size());
}

} // namespace

std::vector<MemberId> sketched_members(const Work& work)
{
    std::vector<MemberId> members;
    if (work.sketched_line != nullptr)
        for (const auto& on : work.sketched_line->path.members) members.push_back(on.member);
    else
        for (std::size_t i = 0; i < work.document.model.members.size(); ++i) members.emplace_back(i);
    return members;
}

std::optional<MemberId> member_beside(const femoop::Model& model, std::span<const MemberId> among,
                                      std::span<const Vector2d> stroke, const PencilView& view)
{
    constexpr double reach = 0.75; // of the longest member: a short one may have the largest ordinate
    double longest = 0.0;
    for (const MemberId member : among) longest = std::max(longest, femoop::geometry_of(model, model[member]).length);
    std::optional<MemberId> nearest;
    double least = 0.0;
    if (stroke.empty()) return nearest;
    for (const MemberId member : among) {
        const femoop::MemberGeometry ends = femoop::geometry_of(model, model[member]);
        if (!(ends.length > 0.0)) continue;
        const double distance = mean_distance(ends, stroke, view);
        if (!(distance <= reach * longest * view.scale()) || (nearest && distance >= least)) continue;
        nearest = member;
        least = distance;
    }
    return nearest;
}

Vector3d moment_side(const femoop::MemberGeometry& member, MomentSide side)
{
    const double positive = side == MomentSide::Tension ? -1.0 : 1.0; // a positive moment stretches the -y' side
    return positive * member.axes.row(1).transpose();
}

bool shows_ordinates(const femoop::Model& model, const drawing::InfluencePicture& line, const PencilView& view)
{
    return std::ranges::any_of(line.path.members, [&](const femoop::influence::PathMember& on) {
        const femoop::MemberGeometry member = femoop::geometry_of(model, model[on.member]);
        const std::vector<Vector2d> start{view.place(member.start)};
        const Vector3d side = drawing::ordinate_side(line.load, member, view.is_flat());
        return member.length > 0.0 && !stroke_along(member, side, start, view).empty();
    });
}

std::vector<StrokePoint> stroke_along(const femoop::MemberGeometry& member, const Vector3d& side,
                                      std::span<const Vector2d> path, const PencilView& view)
{
    constexpr double flattest = 0.05; // of the parallelogram of both that is seen from the front
    const Vector2d start = view.place(member.start), x = view.direction(member.axes.row(0)), y = view.direction(side);
    const double area = x.x() * y.y() - x.y() * y.x();
    std::vector<StrokePoint> stroke;
    if (std::abs(area) < flattest * view.scale() * view.scale()) return stroke;
    for (const Vector2d& place : path) {
        const Vector2d r = place - start;
        stroke.push_back({(r.x() * y.y() - r.y() * y.x()) / (area * member.length),
                          (x.x() * r.y() - x.y() * r.x()) / (area * member.length)});
    }
    return stroke;
}

} // namespace frame
