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

std::optional<Change> PredictTool::press(const Work& work, const Aim& at)
{
    path_.clear();
    press_ = at;
    is_drawing_ = false;
    if (work.prediction != nullptr) path_.push_back(at.pointer);
    return std::nullopt;
}

std::optional<Change> PredictTool::move(const Work& work, const Aim& to)
{
    if (!path_.empty() && (to.pointer - path_.back()).norm() >= to.pixel) path_.push_back(to.pointer);
    is_drawing_ = is_drawing_ || to.is_dragged_from(press_);
    const std::vector<Vector2d> seen = path_.empty() ? std::vector<Vector2d>{to.pointer} : path_;
    member_ = work.prediction != nullptr ? member_beside(work.document.model, sketched_members(work), seen)
                                         : std::nullopt;
    return std::nullopt;
}

namespace {

double distance_to(const Vector2d& a, const Vector2d& b, const Vector2d& place)
{
    const Vector2d along = b - a;
    const double t = std::clamp((place - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (a + t * along - place).norm();
}

/// Of the path's members it is the one that some place of the stroke is nearest to.
bool is_nearest_somewhere(const femoop::Model& model, const femoop::influence::PathLayout& path, MemberId member,
                          std::span<const Vector2d> stroke)
{
    const auto distance = [&](MemberId other, const Vector2d& place) {
        const femoop::MemberGeometry ends = femoop::geometry_of(model, model[other]);
        return distance_to(ends.start.head<2>(), ends.end.head<2>(), place);
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
void sketch_line(const Work& work, MemberId nearest, std::span<const Vector2d> path)
{
    constexpr double clearly = 0.2;
    const femoop::Model& model = work.document.model;
    const drawing::InfluencePicture& asked = *work.sketched_line;
    for (const auto& on : asked.path.members) {
        const femoop::MemberGeometry line = femoop::geometry_of(model, model[on.member]);
        if (!(line.length > 0.0)) continue;
        const auto along = stroke_along(line, drawing::ordinate_side(asked.load, line, true), path);
        const bool is_beside = on.member == nearest || (share_passed(along) > clearly &&
                                                        is_nearest_somewhere(model, asked.path, on.member, path));
        if (is_beside) work.prediction->draw(model, asked.line.effect, on.member, along);
    }
}

} // namespace

std::optional<Change> PredictTool::release(const Work& work, const Aim&)
{
    const std::vector<Vector2d> path = std::exchange(path_, {});
    const femoop::Model& model = work.document.model;
    const auto member = member_beside(model, sketched_members(work), path);
    if (work.prediction == nullptr || !member || !is_drawing_) return std::nullopt;
    if (work.sketched_line != nullptr) {
        sketch_line(work, *member, path);
        return std::nullopt;
    }
    const femoop::MemberGeometry line = femoop::geometry_of(model, model[*member]);
    work.prediction->draw(model, settings_.load_case, *member,
                          stroke_along(line, moment_side(line, settings_.moment_side), path));
    return std::nullopt;
}

bool PredictTool::escape() { return !std::exchange(path_, {}).empty(); }

namespace {

double mean_distance(const femoop::MemberGeometry& ends, std::span<const Vector2d> path)
{
    double sum = 0.0;
    for (const Vector2d& place : path) sum += distance_to(ends.start.head<2>(), ends.end.head<2>(), place);
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
                                      std::span<const Vector2d> stroke)
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
        const double distance = mean_distance(ends, stroke);
        if (!(distance <= reach * longest) || (nearest && distance >= least)) continue;
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

std::vector<StrokePoint> stroke_along(const femoop::MemberGeometry& member, const Vector3d& side,
                                      std::span<const Vector2d> path)
{
    const Vector3d x = member.axes.row(0), y = member.axes.row(1);
    std::vector<StrokePoint> stroke;
    for (const Vector2d& place : path) {
        const Vector3d from_start = Vector3d(place.x(), place.y(), 0.0) - member.start;
        const double ordinate = from_start.dot(y) / side.dot(y);
        stroke.push_back({(from_start.dot(x) - ordinate * side.dot(x)) / member.length, ordinate / member.length});
    }
    return stroke;
}

} // namespace frame
