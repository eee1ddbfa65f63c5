#include "apps/frame/tools/snap.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "apps/frame/document/drawing_names.h"
#include "femoop/edit/crossing.h"
#include "femoop/edit/member_line.h"

namespace frame {

using Eigen::Vector2d;
using femoop::Model;

namespace {

struct Line {
    Vector2d start, chord;
    double length() const { return chord.norm(); }
    Vector2d at(double share) const { return start + share * chord; }
    /// Share of the chord at the foot of a place.
    double foot(const Vector2d& place) const { return chord.dot(place - start) / chord.squaredNorm(); }
};

bool moves(const SnapOptions& options, femoop::NodeId node)
{
    return std::ranges::find(options.moving, node) != options.moving.end();
}

std::vector<Line> resting_lines(const Model& model, const SnapOptions& options)
{
    std::vector<Line> lines;
    for (const femoop::Member& member : model.members) {
        if (moves(options, member.nodes[0]) || moves(options, member.nodes[1])) continue;
        const Vector2d start = place_of(model, member.nodes[0]);
        const Line line{start, place_of(model, member.nodes[1]) - start};
        if (line.length() > 0.0) lines.push_back(line);
    }
    return lines;
}

bool is_inside(double share) { return share > 0.0 && share < 1.0; }

std::optional<Vector2d> crossing(const Line& a, const Line& b)
{
    const double determinant = a.chord.x() * b.chord.y() - a.chord.y() * b.chord.x();
    if (std::abs(determinant) <= 1e-12 * a.length() * b.length()) return std::nullopt;
    const Vector2d r = b.start - a.start;
    const double s = (r.x() * b.chord.y() - r.y() * b.chord.x()) / determinant;
    const double t = (r.x() * a.chord.y() - r.y() * a.chord.x()) / determinant;
    return is_inside(s) && is_inside(t) ? std::optional(a.at(s)) : std::nullopt;
}

/// Collects candidates and keeps the best.
class Magnet {
public:
    Magnet(const Vector2d& pointer, double reach) : pointer_(pointer), reach_(reach) {}

    void offer(const Vector2d& place, SnapKind kind) { offer(place, kind, kind); }
    /// As strong as another kind, of which the nearest wins.
    void offer(const Vector2d& place, SnapKind kind, SnapKind strength)
    {
        const double distance = (place - pointer_).norm();
        if (distance > reach_) return;
        if (best_ && (strength_ < strength || (strength_ == strength && distance_ <= distance))) return;
        best_ = Snap{place, kind};
        strength_ = strength;
        distance_ = distance;
    }
    const std::optional<Snap>& best() const { return best_; }

private:
    Vector2d pointer_;
    double reach_;
    std::optional<Snap> best_;
    SnapKind strength_ = SnapKind::Free;
    double distance_ = 0.0;
};

double rounded(double x, double step) { return step > 0.0 ? step * std::round(x / step) : x; }
Vector2d rounded(const Vector2d& place, double step) { return {rounded(place.x(), step), rounded(place.y(), step)}; }

void offer_crossings(Magnet& magnet, const std::vector<Line>& near)
{
    for (std::size_t i = 0; i < near.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (const std::optional<Vector2d> place = crossing(near[j], near[i]))
                magnet.offer(*place, SnapKind::Intersection);
}

void offer_line(Magnet& magnet, const Line& line, const Vector2d& pointer, const SnapOptions& options)
{
    magnet.offer(line.at(0.5), SnapKind::Midpoint);
    const double along = rounded(line.foot(pointer) * line.length(), options.fine) / line.length();
    if (is_inside(along)) magnet.offer(line.at(along), SnapKind::OnMember);
    if (!options.from) return;
    const double share = line.foot(*options.from);
    const bool begins_on_line = (line.at(share) - *options.from).norm() <= 1e-9 * line.length();
    if (is_inside(share) && !begins_on_line) magnet.offer(line.at(share), SnapKind::Perpendicular);
}

/// A ray of 15 degrees, or a multiple of it, from where drawing began.
struct Ray {
    Ray(const Vector2d& from, const Vector2d& pointer) : start(from)
    {
        constexpr double step = std::numbers::pi / 12.0;
        const Vector2d arm = pointer - from;
        const double angle = rounded(std::atan2(arm.y(), arm.x()), step);
        direction = rounded({std::cos(angle), std::sin(angle)}, std::abs(std::sin(2.0 * angle)) < 1e-9 ? 1.0 : 0.0);
        along = arm.dot(direction);
    }
    Vector2d at(double length) const { return start + length * direction; }
    /// Nearest to the pointer: at a multiple of `step` from the origin where the ray is level or upright, since then its
    /// coordinate is what is read, else from its start.
    Vector2d round_place(double step) const
    {
        const double counted_from = direction.cwiseAbs().maxCoeff() == 1.0 ? direction.dot(start) : 0.0;
        const double length = rounded(counted_from + along, step) - counted_from;
        return at(length > 0.0 ? length : along);
    }

    Vector2d start, direction;
    double along; ///< to the foot of the pointer
};

void offer_ray(Magnet& magnet, const Vector2d& pointer, const Vector2d& from, const SnapOptions& options)
{
    const Ray ray(from, pointer);
    const Vector2d on_grid = ray.round_place(options.grid);
    const bool is_near = options.grid > 0.0 && (on_grid - pointer).norm() <= options.reach;
    const bool is_level_or_upright = ray.direction.cwiseAbs().maxCoeff() == 1.0;
    magnet.offer(is_near ? on_grid : ray.round_place(options.fine), SnapKind::Ray,
                 is_level_or_upright ? SnapKind::Grid : SnapKind::Ray);
}

void offer_parts(Magnet& magnet, const Model& model, const Vector2d& pointer, const SnapOptions& options)
{
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        const femoop::NodeId node(i);
        if (!moves(options, node)) magnet.offer(place_of(model, node), SnapKind::Node);
    }
    std::vector<Line> near;
    for (const Line& line : resting_lines(model, options)) {
        const Vector2d nearest = line.at(std::clamp(line.foot(pointer), 0.0, 1.0));
        if ((nearest - pointer).norm() <= options.reach) near.push_back(line);
    }
    for (const Line& line : near) offer_line(magnet, line, pointer, options);
    offer_crossings(magnet, near);
}

/// Where others cross the line, as distances along it.
std::vector<double> crossings_of(const Model& model, const femoop::MemberLine& line)
{
    std::vector<double> places;
    const double nearness = femoop::nearness_of(model);
    for (const femoop::Member& member : model.members)
        if (const auto place = femoop::crossing(line, femoop::line_of(model, member), nearness))
            places.push_back((*place - line.start).dot(line.direction));
    return places;
}

} // namespace

SnapInSpace snap_on_member(const Model& model, const Cut& pointed, const SnapInSpaceOptions& options)
{
    const femoop::MemberLine line = femoop::line_of(model, model[pointed.member]);
    const auto is_near = [&](double x) { return std::abs(x - pointed.x) <= options.reach; };
    if (options.is_off) return {line.at(pointed.x), SnapKind::Free};
    for (const double x : crossings_of(model, line))
        if (is_near(x)) return {line.at(x), SnapKind::Intersection};
    if (is_near(0.5 * line.length)) return {line.at(0.5 * line.length), SnapKind::Midpoint};
    const double foot = options.from ? (*options.from - line.start).dot(line.direction) : 0.0;
    const bool begins_beside = options.from && (line.at(foot) - *options.from).norm() > femoop::nearness_of(model);
    if (begins_beside && is_inside(foot / line.length) && is_near(foot))
        return {line.at(foot), SnapKind::Perpendicular};
    return {line.at(std::clamp(rounded(pointed.x, options.fine), 0.0, line.length)), SnapKind::OnMember};
}

Vector2d place_of(const Model& model, femoop::NodeId node) { return {model[node].at[0], model[node].at[1]}; }

Snap snap(const Model& model, const Vector2d& pointer, const SnapOptions& options)
{
    if (options.is_off) return {pointer, SnapKind::Free};
    Magnet magnet(pointer, options.reach);
    if (options.from) magnet.offer(*options.from, SnapKind::Node);
    if (options.to_parts) offer_parts(magnet, model, pointer, options);
    if (options.grid > 0.0) magnet.offer(rounded(pointer, options.grid), SnapKind::Grid);
    if (options.from && options.to_parts) offer_ray(magnet, pointer, *options.from, options);
    return magnet.best().value_or(Snap{rounded(pointer, options.fine), SnapKind::Free});
}

} // namespace frame
