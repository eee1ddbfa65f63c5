#include "apps/drawing/results/diagram.h"

#include "apps/drawing/results/line_diagram.h"
#include "apps/drawing/results/ordinates.h"
#include "apps/drawing/structure/members.h"
#include "femoop/load/place_along.h"
#include "femoop/model/quantity/six_digits.h"
#include "femoop/result/components.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

namespace drawing {

namespace {

using femoop::Curve;
using femoop::MemberComponent;

bool is_truss_force(const Scene& scene, MemberComponent component)
{
    return femoop::is_truss(scene.model.analysis) && component == MemberComponent::N;
}

/// "12.5", or of a truss "12.5 (T)".
std::string value_text(const Scene& scene, MemberComponent component, double value)
{
    const bool shows_sense = is_truss_force(scene, component);
    const double shown = has_signs(scene, component) && !shows_sense ? value : std::abs(value);
    const std::string sense = !shows_sense || value == 0.0 ? "" : value > 0.0 ? " (T)" : " (C)";
    return scene.number(shown, measure_of(component)) + sense;
}

double height_of(const Scene& scene)
{
    double top = 0.0;
    double bottom = 0.0;
    for (std::size_t i = 0; i < scene.shape.nodes.size(); ++i) {
        const double y = scene.place(femoop::NodeId{i}).y;
        top = i == 0 ? y : std::min(top, y);
        bottom = i == 0 ? y : std::max(bottom, y);
    }
    return bottom - top;
}

LineDiagram look_of(const Scene& scene, femoop::MemberId id, const Curve& curve, const Diagram& diagram)
{
    const MemberShape& member = scene.shape[id];
    return {.frame = diagram_frame(scene, member, diagram.component),
            .role = role_of(diagram.component),
            .largest = diagram.largest,
            .pixels_per_unit = diagram.pixels_per_unit,
            .has_signs = has_signs(scene, diagram.component),
            .text = [&scene, &diagram](double value) { return value_text(scene, diagram.component, value); },
            .number = [id, &curve,
                       &diagram](double x,
                                 double value) { return number_on_diagram(id, curve, diagram.component, x, value); }};
}

// A band has one breadth: a member whose force changes along it gets a diagram.
bool has_one_force(const Curve& curve, double largest)
{
    const femoop::Extremes N = curve.extremes(MemberComponent::N);
    return N.max.value - N.min.value <= written_as_zero * largest;
}

// The force of a bar, written beside it.
void write_force(const Scene& scene, femoop::MemberId id, double N, double half, Rank rank)
{
    const MemberShape& member = scene.shape[id];
    const ui::Point along = scene.projection.direction(member.x());
    const double length = member.length * scene.projection.scale();
    const auto target = [&](double x) { return scene.projection(member.start) + x * length * along; };
    scene.sketch.caption({.text = value_text(scene, MemberComponent::N, N),
                          .role = ui::Role::AxialForce,
                          .target = target(0.5),
                          .toward = ui::left_normal(ui::direction(along)),
                          .gap = 4.0 + half,
                          .rank = rank,
                          .others = {target(0.4), target(0.6), target(0.3), target(0.7), target(0.2), target(0.8)},
                          .along = along,
                          .number = number_at_section({id, 0.5 * member.length}, MemberComponent::N, member.length)});
}

// The bar as broad as its force is large; tension is filled, compression is hatched.
void draw_band(const Scene& scene, femoop::MemberId id, const Curve& curve, const Diagram& diagram)
{
    Sketch& sketch = scene.sketch;
    const MemberShape& member = scene.shape[id];
    const double N = curve.value(MemberComponent::N, 0.5 * curve.length());
    const double share = diagram.largest > 0.0 ? std::abs(N) / diagram.largest : 0.0;
    const bool is_zero = share <= written_as_zero;
    const double half = sketch.px(1.5 + 5.0 * share);
    const double length = member.length * scene.projection.scale();
    const double end = std::min(sketch.px(8.0), 0.15 * length);
    const ui::Point along = scene.projection.direction(member.x());
    const ui::Point across = ui::left_normal(ui::direction(along));
    const ui::Point a = scene.projection(member.start);
    const auto corner = [&](double x, double y) { return a + x * along + y * across; };
    if (!is_zero) {
        const ui::LayerScope layer(sketch.painter(), ui::Layer::Areas);
        const ui::Stroke stroke = sketch.thin(ui::Role::AxialForce);
        const std::vector<ui::Point> band{corner(end, half), corner(length - end, half), corner(length - end, -half),
                                          corner(end, -half)};
        const double opacity = N > 0.0 ? 0.55 : 0.12;
        sketch.polygon(band, ui::with_opacity(stroke.color, opacity), Clearance::Soft);
        sketch.polyline(band, stroke, Clearance::Soft, ui::PathEnds::Closed);
        const double step = sketch.px(6.0);
        if (N < 0.0)
            for (double x = end + step; x < length - end; x += step)
                sketch.line(corner(x - half, -half), corner(x, half), stroke, Clearance::None);
    }
    if (!scene.shows(Show::Values)) return;
    write_force(scene, id, is_zero ? 0.0 : N, half, share >= 1.0 - written_as_zero ? Rank::Largest : Rank::Value);
}

bool is_hinged(const Scene& scene, const femoop::MemberEnd& end, femoop::NodeId node)
{
    return scene.model[node].hinge || end.release.contains(femoop::Dof::rz);
}

// Made as a bar, or hinged at both ends: the bars of a truss in a plane frame.
bool acts_as_bar(const Scene& scene, femoop::MemberId id)
{
    const femoop::Member& member = scene.model[id];
    return is_bar(scene.model, id) ||
           (is_hinged(scene, member.start, member.nodes[0]) && is_hinged(scene, member.end, member.nodes[1]));
}

bool is_zero_bar(const Scene& scene, femoop::MemberId id, const Curve& curve, const Diagram& diagram)
{
    if (diagram.component != MemberComponent::N || !acts_as_bar(scene, id)) return false;
    const femoop::Extremes N = curve.extremes(MemberComponent::N);
    return std::max(std::abs(N.max.value), std::abs(N.min.value)) <= written_as_zero * diagram.largest;
}

} // namespace

femoop::MovingEffect number_at_section(const Cut& cut, MemberComponent component, double length)
{
    constexpr double near = 1e-9; // of the length
    femoop::MovingEffect number{.quantity = femoop::is_displacement(component) ? femoop::ExpectedQuantity::Displacement
                                                                               : femoop::ExpectedQuantity::SectionForce,
                                .member = cut.member,
                                .component = component};
    if (cut.x <= near * length) number.at = femoop::Percent{0.0};
    else if (cut.x >= (1.0 - near) * length) number.at = femoop::Percent{100.0};
    else number.at = femoop::Quantity(cut.x, femoop::six_digits(cut.x, femoop::english));
    return number;
}

femoop::MovingEffect number_on_diagram(femoop::MemberId id, const Curve& curve, MemberComponent component, double x,
                                       double value)
{
    femoop::MovingEffect number = number_at_section({id, x}, component, curve.length());
    if (!std::holds_alternative<femoop::Quantity>(*number.at)) return number;
    const femoop::Extremes extremes = curve.extremes(component);
    const bool is_min_greater = std::abs(extremes.min.value) > std::abs(extremes.max.value);
    const femoop::Extreme& greater = is_min_greater ? extremes.min : extremes.max;
    if (greater.x == x && greater.value == value) {
        number.quantity = femoop::ExpectedQuantity::Extreme;
        number.at.reset();
        return number;
    }
    const double before = curve.value(component, x, femoop::Side::Before);
    if (before != curve.value(component, x)) number.side = before == value ? femoop::Side::Before : femoop::Side::After;
    return number;
}

ui::Role role_of(MemberComponent component)
{
    switch (component) {
    case MemberComponent::N: return ui::Role::AxialForce;
    case MemberComponent::Vy:
    case MemberComponent::Vz: return ui::Role::ShearForce;
    case MemberComponent::T: return ui::Role::Torsion;
    default: return ui::Role::BendingMoment;
    }
}

ui::Measure measure_of(MemberComponent component)
{
    switch (component) {
    case MemberComponent::N:
    case MemberComponent::Vy:
    case MemberComponent::Vz: return ui::Measure::Force;
    case MemberComponent::T:
    case MemberComponent::My:
    case MemberComponent::Mz: return ui::Measure::Moment;
    default: return ui::Measure::Displacement;
    }
}

Diagram make_diagram(const Scene& scene, const SolvedCase& solved, MemberComponent component, ui::Size panel)
{
    return make_diagram(scene, component, largest_value(solved, component, scene.shape.size), panel);
}

Diagram make_diagram(const Scene& scene, MemberComponent component, double largest, ui::Size panel)
{
    Diagram diagram{.component = component, .largest = largest};
    if (!(diagram.largest > 0.0)) return diagram;
    const double share = drawing::is_moment(component) ? 0.17 : 0.125;
    const LockedScale* const locked = scene.locked_scale();
    const double scaled_for = scaling_value(locked ? (*locked)[component] : 0.0, diagram.largest);
    diagram.pixels_per_unit = ordinate_height(scene, share, panel) * scene.options.diagram_factor / scaled_for;
    return diagram;
}

double ordinate_height(const Scene& scene, double share, ui::Size panel)
{
    // What the structure itself leaves free of the panel's height makes a beam's diagrams higher.
    const double spare = std::max(0.0, panel.height - height_of(scene) - 100.0);
    const double room = share * (std::min(panel.width, panel.height) + 0.6 * spare);
    return std::clamp(std::min(room, 3.2 * share * scene.detail.median_length()), 16.0, 130.0);
}

void draw_diagram(const Scene& scene, const SolvedCase& solved, const Diagram& diagram)
{
    if (!(diagram.largest > 0.0) && diagram.component != MemberComponent::N) return;
    const bool is_truss = is_truss_force(scene, diagram.component);
    for (std::size_t i = 0; i < scene.shape.members.size(); ++i) {
        const femoop::MemberId id{i};
        if (is_truss && has_one_force(solved[id], diagram.largest)) draw_band(scene, id, solved[id], diagram);
        else if (scene.shows(Show::Values) && is_zero_bar(scene, id, solved[id], diagram))
            write_force(scene, id, 0.0, 0.0, Rank::Value);
        else if (!diagram.is_zero())
            draw(scene, SectionForce(solved[id], diagram.component), look_of(scene, id, solved[id], diagram));
    }
}

void mark_effect(const Scene& scene, const SolvedCase& solved, const Diagram& diagram,
                 const femoop::MovingEffect& effect)
{
    constexpr double rounding = 1e-9; // of the largest value
    const MemberShape& member = scene.shape[*effect.member];
    const Curve& curve = solved[*effect.member];
    const double x = std::clamp(femoop::along(*effect.at, member.length), 0.0, member.length);
    const double found = curve.value(diagram.component, x, effect.side.value_or(femoop::Side::After));
    const double value = std::abs(found) <= rounding * diagram.largest || diagram.is_zero() ? 0.0 : found;
    const SymbolFrame frame = diagram_frame(scene, member, diagram.component);
    const double along = x * scene.projection.scale();
    const ui::Point foot = frame(along, 0.0), top = frame(along, value * diagram.pixels_per_unit);
    const ui::Role role = role_of(diagram.component);
    Sketch& sketch = scene.sketch;
    sketch.line(foot, top, sketch.stroke(role), Clearance::Soft);
    sketch.disc(foot, sketch.px(5.0), sketch.theme().background());
    sketch.ring(foot, sketch.px(5.0), sketch.stroke(role));
    sketch.disc(top, sketch.px(3.0), sketch.theme().stroke(role).color, Clearance::Soft);
    const femoop::Extremes extremes = curve.extremes(diagram.component);
    const double near = 1e-6 * member.length;
    const bool is_written = x <= near || x >= member.length - near || std::abs(x - extremes.max.x) <= near ||
                            std::abs(x - extremes.min.x) <= near;
    if (is_written || !scene.shows(Show::Values)) return;
    sketch.caption({.text = value_text(scene, diagram.component, value),
                    .role = role,
                    .target = top,
                    .toward = ui::direction(top - foot == ui::Point{} ? frame(along, 1.0) - foot : top - foot),
                    .gap = sketch.px(5.0),
                    .rank = Rank::Largest,
                    .others = {foot}});
}

} // namespace drawing
