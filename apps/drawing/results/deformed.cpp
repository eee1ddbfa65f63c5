#include "apps/drawing/results/deformed.h"

#include "apps/drawing/results/diagram.h"
#include "apps/drawing/structure/members.h"

#include <algorithm>
#include <cmath>

namespace drawing {

namespace {

using Eigen::Vector3d;
using femoop::Curve;
using femoop::MemberComponent;

constexpr double drawn_share = 0.1; // of the structure's diagonal

double size_of(const femoop::LocalDisplacement& d) { return std::hypot(d.u, d.v, d.w); }

/// The axis of one member, displaced.
class DeformedMember {
public:
    DeformedMember(const Scene& scene, const MemberShape& member, const Curve& curve, double factor)
        : scene_(scene), member_(member), curve_(curve), factor_(factor)
    {}

    Vector3d place(double x) const
    {
        const femoop::LocalDisplacement d = curve_.displacement(x);
        return member_.at(x) + factor_ * (d.u * member_.x() + d.v * member_.y() + d.w * member_.z());
    }

    std::vector<ui::Point> line() const
    {
        std::vector<ui::Point> points{on_sheet(0.0)};
        const std::vector<double> breaks = curve_.breaks();
        for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
            subdivide(breaks[i], points.back(), breaks[i + 1], on_sheet(breaks[i + 1]), 0, points);
            points.push_back(on_sheet(breaks[i + 1]));
        }
        return points;
    }

private:
    ui::Point on_sheet(double x) const { return scene_.projection(place(x)); }

    void subdivide(double a, ui::Point at_a, double b, ui::Point at_b, int depth, std::vector<ui::Point>& points) const
    {
        constexpr int least_depth = 2; // a member bent in an S has its middle on the chord
        constexpr int most_depth = 8;
        if (depth >= most_depth) return;
        const double middle = 0.5 * (a + b);
        const ui::Point at_middle = on_sheet(middle);
        if (depth >= least_depth && ui::distance(at_middle, 0.5 * (at_a + at_b)) < 0.25) return;
        subdivide(a, at_a, middle, at_middle, depth + 1, points);
        points.push_back(at_middle);
        subdivide(middle, at_middle, b, at_b, depth + 1, points);
    }

    const Scene& scene_;
    const MemberShape& member_;
    const Curve& curve_;
    double factor_;
};

Vector3d displaced(const Scene& scene, const SolvedCase& solved, femoop::NodeId node, double factor)
{
    const femoop::NodeVector d = solved.result.displacement(node);
    return scene.shape[node] + factor * Vector3d(d[0], d[1], d[2]);
}

void draw_arms(const Scene& scene, const SolvedCase& solved, femoop::MemberId id, double factor,
               const std::vector<ui::Point>& line)
{
    const femoop::Member& member = scene.model[id];
    const ui::Stroke stroke = scene.sketch.stroke(ui::Role::Deformed);
    if (!member.start.offset.empty())
        scene.sketch.line(scene.projection(displaced(scene, solved, member.nodes[0], factor)), line.front(), stroke);
    if (!member.end.offset.empty())
        scene.sketch.line(line.back(), scene.projection(displaced(scene, solved, member.nodes[1], factor)), stroke);
}

/// Of its components the one that counts most.
femoop::MovingEffect number_of(const LargestDisplacement& largest, const SolvedCase& solved)
{
    const Curve& curve = solved[largest.member];
    MemberComponent greatest = MemberComponent::v;
    for (const MemberComponent one : {MemberComponent::u, MemberComponent::w})
        if (std::abs(curve.value(one, largest.x)) > std::abs(curve.value(greatest, largest.x))) greatest = one;
    return number_at_section({largest.member, largest.x}, greatest, curve.length());
}

void write_largest(const Scene& scene, const SolvedCase& solved, double factor)
{
    const LargestDisplacement largest = largest_displacement(solved);
    if (!(largest.value > 0.0) || !scene.shows(Show::Values)) return;
    const MemberShape& member = scene.shape[largest.member];
    const Vector3d from = member.at(largest.x);
    const Vector3d to = DeformedMember(scene, member, solved[largest.member], factor).place(largest.x);
    const ui::Point a = scene.projection(from);
    const ui::Point b = scene.projection(to);
    ui::Stroke stroke = scene.sketch.thin(ui::Role::Deformed);
    stroke.dash = {2.0, 2.0};
    scene.sketch.line(a, b, stroke);
    scene.sketch.disc(b, scene.sketch.px(3.0), scene.sketch.stroke(ui::Role::Deformed).color);
    scene.sketch.caption({.text = "δ = " + scene.text(largest.value, ui::Measure::Displacement),
                          .role = ui::Role::Deformed,
                          .target = b,
                          .toward = ui::distance(a, b) > 1.0 ? b - a : ui::Point{0.0, -1.0},
                          .gap = scene.sketch.px(5.0),
                          .rank = Rank::Extreme,
                          .number = number_of(largest, solved)});
}

} // namespace

LargestDisplacement largest_displacement(const SolvedCase& solved)
{
    LargestDisplacement largest;
    double longest = 0.0;
    for (std::size_t i = 0; i < solved.curves.size(); ++i) {
        const Curve& curve = solved.curves[i];
        std::vector<double> places{0.0, curve.length()};
        for (const MemberComponent c : {MemberComponent::v, MemberComponent::w}) {
            const femoop::Extremes e = curve.extremes(c);
            places.push_back(e.max.x);
            places.push_back(e.min.x);
        }
        for (const double x : places) {
            const double value = size_of(curve.displacement(x));
            // The same place seen from two members is told from the first.
            if (value > largest.value * (1.0 + 1e-9)) largest = {value, femoop::MemberId{i}, x};
        }
        longest = std::max(longest, curve.length());
    }
    constexpr double round_off = 1e-15; // of the longest member
    return largest.value > round_off * longest ? largest : LargestDisplacement{};
}

double deformation_scale(const Scene& scene, const SolvedCase& solved, ui::Size panel)
{
    if (scene.options.deformation_scale) return *scene.options.deformation_scale;
    const LockedScale* const locked = scene.locked_scale();
    const double largest = scaling_value(locked ? locked->displacement : 0.0, largest_displacement(solved).value);
    if (!(largest > 1e-15 * scene.shape.size) || !std::isfinite(largest)) return 1.0;
    const double room = 0.22 * std::min(panel.width, panel.height) / scene.projection.scale();
    return round_below(std::min(drawn_share * scene.shape.size, room) / largest);
}

void draw_deformed(const Scene& scene, const SolvedCase& solved, double scale)
{
    const double factor = scale * scene.state.phase;
    for (std::size_t i = 0; i < scene.shape.members.size(); ++i) {
        const femoop::MemberId id{i};
        const std::vector<ui::Point> line = DeformedMember(scene, scene.shape[id], solved[id], factor).line();
        scene.sketch.polyline(line, scene.sketch.stroke(ui::Role::Deformed));
        draw_arms(scene, solved, id, factor, line);
    }
    const ui::LayerScope layer(scene.sketch.painter(), ui::Layer::Symbols);
    write_largest(scene, solved, factor);
}

} // namespace drawing
