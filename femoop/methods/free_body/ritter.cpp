#include "femoop/methods/free_body/ritter.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace femoop::free_body {

namespace {

using Eigen::Vector3d;

constexpr double negligible = 1e-9; // of the structure's size, and of the sine between two bars

double about_z(const Vector3d& arm, const Vector3d& force) { return arm.cross(force).z(); }

/// A bar where the body is cut off.
struct CutBar {
    MemberId member;
    Vector3d at, outward; ///< outward: the way in which its tension pulls the body
};

bool carries_normal_force_alone(const Discretisation& structure, MemberId member)
{
    const MemberEndConditions* const conditions = structure.end_conditions_of(member);
    return conditions != nullptr && conditions->is_bar;
}

std::vector<CutBar> cut_bars(const Discretisation& structure, const Body& body)
{
    std::vector<CutBar> bars;
    for (const Piece& piece : body.pieces) {
        const MemberGeometry geometry = structure.geometry(piece.member);
        const Vector3d along = geometry.axes.row(0);
        if (piece.begins_at_cut) bars.push_back({piece.member, geometry.at(piece.from), -along});
        if (piece.ends_at_cut) bars.push_back({piece.member, geometry.at(piece.to), along});
    }
    return bars;
}

/// Where two lines meet in the plane; nothing if they are parallel.
std::optional<Vector3d> meeting(const CutBar& a, const CutBar& b)
{
    const double sine = about_z(a.outward, b.outward);
    if (std::abs(sine) <= negligible) return std::nullopt;
    return a.at + about_z(b.at - a.at, b.outward) / sine * a.outward;
}

/// Where all bars but one meet.
std::optional<Vector3d> meeting_but(const std::vector<CutBar>& bars, std::size_t one, double near)
{
    std::optional<Vector3d> found;
    for (std::size_t i = 0; i < bars.size() && !found; ++i)
        for (std::size_t j = i + 1; j < bars.size() && !found; ++j)
            if (i != one && j != one) found = meeting(bars[i], bars[j]);
    for (std::size_t i = 0; i < bars.size() && found; ++i)
        if (i != one && std::abs(about_z(bars[i].at - *found, bars[i].outward)) > near) return std::nullopt;
    return found;
}

} // namespace

std::vector<RitterPoint> ritter_points(const Discretisation& structure, const Body& body,
                                       const std::vector<Force>& forces)
{
    constexpr std::size_t fewest = 3;
    if (!is_plane(structure.kind)) return {};
    const std::vector<CutBar> bars = cut_bars(structure, body);
    const auto is_cut = [&](MemberId member) { return std::ranges::find(bars, member, &CutBar::member) != bars.end(); };
    const bool all_known = std::ranges::all_of(
        forces, [&](const Force& force) { return force.kind != ForceKind::SectionForces || is_cut(*force.member); });
    const bool all_bars = std::ranges::all_of(
        bars, [&](const CutBar& bar) { return carries_normal_force_alone(structure, bar.member); });
    if (bars.size() < fewest || !all_known || !all_bars) return {};
    const double near = negligible * structure.size();
    std::vector<RitterPoint> points;
    for (std::size_t i = 0; i < bars.size(); ++i) {
        const auto at = meeting_but(bars, i, near);
        if (!at) continue;
        const double arm = about_z(bars[i].at - *at, bars[i].outward);
        if (std::abs(arm) <= near) continue;
        points.push_back({.bar = bars[i].member, .at = *at, .arm = arm, .others = {}});
        for (const CutBar& other : bars)
            if (other.member != bars[i].member) points.back().others.push_back(other.at);
    }
    return points;
}

RitterForce ritter_force(const FreeBody& body, const RitterPoint& point)
{
    Equation about = equations(body, AnalysisKind::Truss2d, point.at).back();
    RitterForce found{.moments = std::move(about.moments)};
    std::erase_if(found.moments, [&](const MomentTerm& term) {
        const Force& force = body.forces[term.force];
        return force.member == point.bar && term.of == MemberComponent::N;
    });
    double sum = 0.0;
    for (const MomentTerm& term : found.moments) sum += term.moment;
    found.force = std::abs(sum) <= negligible * about.size ? 0.0 : -sum / point.arm;
    return found;
}

} // namespace femoop::free_body
