#include "apps/mohr/view/construction_words.h"

#include <numbers>
#include <optional>
#include <string_view>

#include "apps/mohr/view/names.h"
#include "femoop/methods/mohr/space_construction.h"

namespace mohr {

namespace fm = femoop::mohr;

namespace {

using ui::translatable;

std::string_view space_sentence(fm::ConstructionStage stage)
{
    using enum fm::ConstructionStage;
    switch (stage) {
    case ThreeValues:
        return translatable(
            "Mark the principal values, the roots of σ³ − I1 σ² + I2 σ − I3 = 0: σ1 = {s1}, σ2 = {s2}, σ3 = {s3}.");
    case LargestCircle: return translatable("Over σ1 and σ3 draw the largest circle: centre {c13}, radius {r13}.");
    case UpperCircle:
        return translatable(
            "Over σ1 and σ2 draw a circle: centre {c12}, radius {r12}. It has the planes that contain direction 3.");
    case LowerCircle:
        return translatable("Over σ2 and σ3 draw a circle: centre {c23}, radius {r23}. "
                            "The point of every plane lies between the three circles.");
    case SpaceShear:
        return translatable("The highest point of the largest circle is the largest shear, {r13}. "
                            "Its plane contains direction 2 and halves the angle between directions 1 and 3.");
    case FromFirst:
        return translatable(
            "The plane's normal makes α = {alpha}° with direction 1: "
            "from σ1 draw a line inclined to the upright by α. Through "
            "the points where it meets both circles of σ1 draw an arc about the centre of the circle over σ2 and σ3.");
    case FromThird:
        return translatable("It makes γ = {gamma}° with direction 3: likewise a line from σ3, "
                            "and an arc about the centre of the circle over σ1 and σ2.");
    case ArcsMeet:
        return translatable("Both arcs meet in N, the point of the plane: read off σ = {on} and τ = {onshear}.");
    default: return "";
    }
}

/// Second moments have axes and a product where stresses and strains have faces and a shear.
std::optional<std::string_view> inertia_sentence(fm::ConstructionStage stage)
{
    using enum fm::ConstructionStage;
    switch (stage) {
    case FaceX: return translatable("Mark X for the axis x: ({x}; {xshear}).");
    case FaceY:
        return translatable("Mark Y for the axis y: ({y}; {yshear}); its product is that of X with the other sign.");
    case PrincipalValues:
        return translatable("Where the circle meets the {normal} axis there is no product: "
                            "{first} = C + R = {firstvalue}, {second} = C − R = {secondvalue}.");
    case LargestShear:
        return translatable("The highest and the lowest point have the largest product, "
                            "R = {radius}, and both have the moment {centre}.");
    case Pole:
        return translatable("Through X draw a line square to the axis x, upright. "
                            "Where it meets the circle again is the pole P.");
    case PrincipalPlanes:
        return translatable("Draw lines from P to both principal points: "
                            "they are square to the principal axes. The first axis makes θp = {thetap}° with x.");
    case Plane:
        return translatable("From P draw a line square to the axis x′, which makes θ = {theta}° with x. "
                            "It meets the circle in N: read off {n} and {nshear}.");
    default: return std::nullopt;
    }
}

/// Written for every reader, filled in below.
std::string_view sentence(Subject subject, fm::ConstructionStage stage)
{
    using enum fm::ConstructionStage;
    if (subject == Subject::Inertia)
        if (const auto own = inertia_sentence(stage)) return *own;
    switch (stage) {
    case Axes: return translatable("Draw the axes at one scale: {normal} to the right, {shear} across; {rule}.");
    case FaceX: return translatable("Mark X for the face x: ({x}; {xshear}).");
    case FaceY:
        return translatable("Mark Y for the face y: ({y}; {yshear}); its shear is that of X with the other sign.");
    case Diameter:
        return translatable(
            "Join X and Y. The line meets the {normal} axis in C, halfway: ({x} + {addedy})/2 = {centre}.");
    case Circle: return translatable("Set the compass in C, open it to X, and draw the circle: R = {radius}.");
    case PrincipalValues:
        return translatable("Where the circle meets the {normal} axis there is no shear: "
                            "{first} = C + R = {firstvalue}, {second} = C − R = {secondvalue}.");
    case LargestShear:
        return translatable("The highest and the lowest point have the largest shear of these planes, "
                            "R = {radius}, and both have the normal component {centre}.");
    case Pole:
        return translatable("Through X draw a line parallel to the face x, which is upright. "
                            "Where it meets the circle again is the pole P.");
    case PrincipalPlanes:
        return translatable(
            "Draw lines from P to both principal points: "
            "they are parallel to the principal planes. The normal of the first plane makes θp = {thetap}° with x.");
    case Plane:
        return translatable("From P draw a line parallel to the plane, whose normal makes θ = {theta}° with x. "
                            "It meets the circle in N: read off {n} and {nshear}.");
    case Point:
        return translatable("X and Y are one point, so the circle is this point: every direction is principal.");
    default: return space_sentence(stage);
    }
    return "";
}

std::string rule_text(Subject subject, const Solution& s, const Look& look)
{
    if (subject == Subject::Inertia) return look.tr("the axis of the product points down and counts −Ixy");
    return s.rule == fm::ShearRule::ClockwiseUp ? look.tr("shear is up where it turns the element clockwise")
                                                : look.tr("the shear axis points down");
}

} // namespace

namespace {

std::string space_caption(fm::ConstructionStage stage, const Solution& s, const Look& look)
{
    using enum fm::ConstructionStage;
    const auto& v = s.space_principal.values;
    const auto [largest, upper, lower] = fm::circles(s.space_principal);
    const double per_degree = 180.0 / std::numbers::pi;
    const auto angle = [&](int direction) {
        return look.number(per_degree * fm::angle_with(s.space_principal, direction, s.on_plane.normal));
    };
    if (stage == Axes)
        return look.tr("Draw the axes at one scale: σ to the right, τ up. "
                       "In space the shear on a plane is a size, so all happens above the axis.");
    if (stage == Point)
        return look.tr("The three values are one, so the circles are this point: every direction is principal.");
    return look.tr(space_sentence(stage), {{"s1", look.number(v[0])},
                                           {"s2", look.number(v[1])},
                                           {"s3", look.number(v[2])},
                                           {"c13", look.number(largest.centre)},
                                           {"r13", look.number(largest.radius)},
                                           {"c12", look.number(upper.centre)},
                                           {"r12", look.number(upper.radius)},
                                           {"c23", look.number(lower.centre)},
                                           {"r23", look.number(lower.radius)},
                                           {"alpha", angle(0)},
                                           {"gamma", angle(2)},
                                           {"on", look.number(s.on_plane.normal_component)},
                                           {"onshear", look.number(s.on_plane.shear)}});
}

} // namespace

std::string caption(fm::ConstructionStage stage, const Document& document, const Solution& s, const Look& look)
{
    if (is_in_space(document.subject)) return space_caption(stage, s, look);
    const Names names = names_of(document.subject);
    const fm::CirclePoint x = fm::face_point(s.plane, 0.0, s.rule),
                          y = fm::face_point(s.plane, 0.5 * std::numbers::pi, s.rule);
    const fm::CirclePoint n = fm::face_point(s.plane, s.angle, s.rule);
    const double per_degree = 180.0 / std::numbers::pi;
    const std::string rule = rule_text(document.subject, s, look);
    const auto number = [&](double value) { return look.number(value); };
    const auto added = [&](double value) { return value < 0.0 ? "(" + number(value) + ")" : number(value); };
    return look.tr(sentence(document.subject, stage), {{"normal", names.normal},
                                                       {"shear", names.shear},
                                                       {"rule", rule},
                                                       {"x", number(x.normal)},
                                                       {"xshear", number(x.shear)},
                                                       {"y", number(y.normal)},
                                                       {"addedy", added(y.normal)},
                                                       {"yshear", number(y.shear)},
                                                       {"centre", number(s.circle.centre)},
                                                       {"radius", number(s.circle.radius)},
                                                       {"first", names.first},
                                                       {"second", names.second},
                                                       {"firstvalue", number(s.principal.first)},
                                                       {"secondvalue", number(s.principal.second)},
                                                       {"thetap", number(s.principal.angle.value_or(0.0) * per_degree)},
                                                       {"theta", number(document.angle)},
                                                       {"n", number(n.normal)},
                                                       {"nshear", number(n.shear)}});
}

std::string mark_name(fm::ConstructionMark mark, const Document& document)
{
    const Names names = names_of(document.subject);
    switch (mark) {
    case fm::ConstructionMark::X: return "X";
    case fm::ConstructionMark::Y: return "Y";
    case fm::ConstructionMark::C: return "C";
    case fm::ConstructionMark::First: return names.first;
    case fm::ConstructionMark::Second: return names.second;
    case fm::ConstructionMark::Top:
    case fm::ConstructionMark::Bottom: return "R";
    case fm::ConstructionMark::P: return "P";
    case fm::ConstructionMark::N: return "N";
    case fm::ConstructionMark::Third: return names.third;
    case fm::ConstructionMark::Helper: return "";
    }
    return "";
}

} // namespace mohr
