#include "apps/frame/tools/free_body_tool.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "apps/frame/tools/snap.h"
#include "femoop/geometry/node_position.h"
#include "femoop/model/dof.h"

namespace frame {

using Eigen::Vector3d;

namespace {

constexpr double reach = 9.0; // [px]

Vector3d place_on_sheet(const Projection& seen_by, const Aim& at) { return seen_by.place_at(at.on_sheet, 0.0); }

/// The axis that the plane is square to in which the hand moves a place; of those seen alike z, then y.
Eigen::Index normal_of_plane(femoop::AnalysisKind kind, const Projection& seen_by)
{
    constexpr double alike = 1e-3;
    if (!femoop::is_3d(kind)) return 2;
    const Vector3d eye = seen_by.toward_eye().cwiseAbs();
    if (eye.z() >= eye.maxCoeff() - alike) return 2;
    return eye.y() >= eye.maxCoeff() - alike ? 1 : 0;
}

/// The place under the hand in the plane square to an axis through another place; where that is seen edge-on, as far
/// along it as the hand goes.
Vector3d place_in_plane_through(const Vector3d& other, Eigen::Index normal, const Aim& at)
{
    constexpr double flattest = 0.05;
    const Vector3d eye = at.projection.toward_eye();
    Vector3d place = at.projection.place_at(at.on_sheet, at.projection.nearness(other));
    if (std::abs(eye[normal]) >= flattest) place += (other - place)[normal] / eye[normal] * eye;
    place[normal] = other[normal];
    return place;
}

Vector3d rounded_in_plane(const Vector3d& place, Eigen::Index normal, double step)
{
    Vector3d rounded = step * (place / step).array().round();
    rounded[normal] = place[normal];
    return rounded;
}

/// Places that the point of moments is drawn to, where the body was.
std::vector<Vector3d> places_to_snap_to(const drawing::FreeBodyPicture& picture, const femoop::Model& model)
{
    std::vector<Vector3d> places;
    for (const auto& point : picture.lifted.ritter_points) places.push_back(point.at);
    for (const auto& force : picture.lifted.forces) places.push_back(force.at);
    for (const femoop::NodeId node : picture.lifted.body.nodes) places.push_back(femoop::position_of(model, node));
    return places;
}

} // namespace

bool FreeBodyTool::is_at_moment_point(const AskedBody& body, const Aim& at)
{
    const drawing::FreeBodyPicture* const picture = body.last();
    return picture != nullptr && distance(at.projection(picture->moment_point()), at.on_sheet) <= reach;
}

// To what is seen nearest, of several that are seen as one to that nearest to the eye, else to a round place; Alt takes
// the place as it is.
Vector3d FreeBodyTool::moment_point(const Work& work, const Aim& at)
{
    const drawing::FreeBodyPicture& picture = *work.free_body->last();
    const femoop::Model& model = work.document.model;
    const Eigen::Index normal = normal_of_plane(model.analysis, at.projection);
    const Vector3d place = place_in_plane_through(picture.moment_point(), normal, at) - picture.aside;
    if (at.is_exact) return place;
    const std::vector<Vector3d> others = places_to_snap_to(picture, model);
    const auto off = [&](const Vector3d& other) {
        const double pixels = distance(at.projection(other + picture.aside), at.on_sheet);
        return std::pair(std::round(pixels), -at.projection.nearness(other));
    };
    const auto nearest = std::ranges::min_element(others, {}, off);
    if (nearest != others.end() && off(*nearest).first <= reach) return *nearest;
    return rounded_in_plane(place, normal, round_grid(4.0 * at.pixel));
}

std::optional<Change> FreeBodyTool::press(const Work& work, const Aim& at)
{
    press_ = at;
    now_ = place_on_sheet(at.projection, at);
    holds_moment_point_ = is_at_moment_point(*work.free_body, at);
    is_dragged_ = false;
    pressed_ = work.free_body;
    before_ = *pressed_;
    return std::nullopt;
}

std::optional<Change> FreeBodyTool::move(const Work& work, const Aim& to)
{
    if (!press_) return std::nullopt;
    now_ = place_on_sheet(press_->projection, to);
    is_dragged_ = is_dragged_ || to.is_dragged_from(*press_);
    if (holds_moment_point_ && is_dragged_ && work.free_body->last() != nullptr)
        work.free_body->put_moment_point(moment_point(work, to));
    return std::nullopt;
}

AskedBody::CutLine FreeBodyTool::line_to(const Aim& at) const
{
    const Projection& seen_by = press_->projection;
    return {place_on_sheet(seen_by, *press_), place_on_sheet(seen_by, at), seen_by.toward_eye()};
}

std::optional<Change> FreeBodyTool::release(const Work& work, const Aim& at)
{
    pressed_ = nullptr;
    if (press_ && !holds_moment_point_) {
        if (is_dragged_) work.free_body->cut(work.document.model, line_to(at));
        else lift(work, *press_);
    }
    press_.reset();
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
    if (!press_) return false;
    *std::exchange(pressed_, nullptr) = before_;
    press_.reset();
    return true;
}

Preview FreeBodyTool::preview() const
{
    Preview preview;
    if (press_ && is_dragged_ && !holds_moment_point_)
        preview.cut = std::pair(place_on_sheet(press_->projection, *press_), now_);
    return preview;
}

} // namespace frame
