#include "apps/mohr/session/drag.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/text/catalogue.h"

namespace mohr {

namespace fm = femoop::mohr;
using ui::translatable;

namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// A hand on the sheet, and the document that it began with.
class DragController {
public:
    DragController(const Grip& grip, bool is_fine)
        : document_(grip.document), s_(grip.solution), drawn_(grip.drawn), frame_(grip.frame), is_fine_(is_fine)
    {}

    Edit edit(Handle handle, ui::Point at) const
    {
        const ui::World2 p = drawn_.circle.to_world(at);
        switch (handle) {
        case Handle::FaceX: return with_state({snapped(p.x), s_.plane.y, snapped(-p.y)});
        case Handle::FaceY: return with_state({s_.plane.x, snapped(p.x), snapped(p.y)});
        case Handle::Plane: return turned_on_circle(p);
        case Handle::Centre: return with_centre(p.x);
        case Handle::First: return is_space() ? with_space_value(p.x, 0) : with_extreme(p.x, true);
        case Handle::Second: return is_space() ? with_space_value(p.x, 1) : with_extreme(p.x, false);
        case Handle::Third: return with_space_value(p.x, 2);
        case Handle::ArrowX:
        case Handle::ArrowY:
        case Handle::ArrowShear: return with_arrow(handle, at);
        case Handle::Turn: return turned_to(angle_of(at - drawn_.element.middle));
        case Handle::Cursor: return at_cursor(at);
        case Handle::Fibre: return at_fibre(at);
        case Handle::Normal: return on_sphere(at);
        case Handle::CubeX:
        case Handle::CubeY:
        case Handle::CubeZ:
        case Handle::CubeXY:
        case Handle::CubeYZ:
        case Handle::CubeZX: return with_cube_arrow(handle, at);
        }
        return {document_};
    }

private:
    bool is_space() const { return is_in_space(document_.subject); }

    double snapped(double value) const
    {
        if (is_fine_) return rounded(value, frame_.largest, 5);
        const double step = round_step(frame_.largest / 120.0);
        return rounded(step * std::round(value / step), frame_.largest, 12);
    }

    Edit with_state(const fm::PlaneState& state) const { return with_plane(document_, state); }

    static double angle_of(ui::Point v) { return std::atan2(-v.y, v.x); }

    Edit turned_to(double angle) const
    {
        const double degrees = angle / degree;
        return with_angle(document_, is_fine_ ? rounded(degrees, 100.0, 5) : std::round(degrees));
    }

    /// The plane whose point of the circle lies where the hand is, seen from the centre; of the two the one that is
    /// nearer to the plane that was.
    Edit turned_on_circle(ui::World2 p) const
    {
        const double x = std::atan2(-s_.plane.xy, s_.plane.x - s_.circle.centre);
        const double twice = std::remainder(std::atan2(p.y, p.x - s_.circle.centre) - x, 2.0 * std::numbers::pi);
        const double near = s_.angle + std::remainder(0.5 * twice - s_.angle, std::numbers::pi);
        return turned_to(near);
    }

    Edit with_centre(double normal) const
    {
        const double shift = snapped(normal) - s_.circle.centre;
        return with_state({tidy(s_.plane.x + shift), tidy(s_.plane.y + shift), s_.plane.xy});
    }

    Edit with_extreme(double value, bool is_first) const
    {
        const double first = is_first ? std::max(snapped(value), s_.principal.second) : s_.principal.first;
        const double second = is_first ? s_.principal.second : std::min(snapped(value), s_.principal.first);
        const fm::PlaneState state = fm::from_principal(first, second, s_.principal.angle.value_or(0.0));
        return with_state({tidy(state.x), tidy(state.y), tidy(state.xy)});
    }

    /// A value stays between its neighbours.
    Edit with_space_value(double value, std::size_t which) const
    {
        fm::SpacePrincipal principal = s_.space_principal;
        const auto& before = s_.space_principal.values;
        double& moved = principal.values[which];
        moved = snapped(value);
        if (which > 0) moved = std::min(moved, before[which - 1]);
        if (which < 2) moved = std::max(moved, before[which + 1]);
        return with_space_principal(document_, principal);
    }

    /// The arrows belong to the turned element; what is turned back is the state.
    Edit with_arrow(Handle handle, ui::Point at) const
    {
        const ui::Point from = at - drawn_.element.middle;
        const ui::Point x{std::cos(s_.angle), -std::sin(s_.angle)}, y{-std::sin(s_.angle), -std::cos(s_.angle)};
        const double per_pixel = frame_.largest / drawn_.element.arrow, base = drawn_.element.half + 5.0;
        fm::PlaneState state = s_.turned;
        // A push is drawn outside too, so that it is its own sign that the hand pulls larger.
        const auto pulled = [&](double before, ui::Point along) {
            return snapped((before < 0.0 ? -per_pixel : per_pixel) * (ui::dot(from, along) - base));
        };
        const double up = ui::dot(from, y);
        if (handle == Handle::ArrowX) state.x = pulled(state.x, x);
        if (handle == Handle::ArrowY) state.y = pulled(state.y, y);
        if (handle == Handle::ArrowShear) state.xy = snapped(2.0 * per_pixel * (up - std::copysign(4.0, up)));
        const fm::PlaneState back = fm::rotated(state, -s_.angle);
        return with_state({tidy(back.x), tidy(back.y), tidy(back.xy)});
    }

    /// The tip follows the hand along its arrow. A push is drawn outside too: pulled, it grows.
    Edit with_cube_arrow(Handle handle, ui::Point at) const
    {
        const auto arrow = std::ranges::find(drawn_.cube, handle, &CubeArrow::handle);
        if (arrow == drawn_.cube.end()) return {document_};
        const bool is_push = handle <= Handle::CubeZ && arrow->value < 0.0;
        const double grown = ui::dot(at - arrow->tip, arrow->growth) / ui::dot(arrow->growth, arrow->growth);
        fm::SpaceState state = *s_.space;
        double* const components[] = {&state.x, &state.y, &state.z, &state.xy, &state.yz, &state.zx};
        const auto which = static_cast<std::size_t>(handle) - static_cast<std::size_t>(Handle::CubeX);
        *components[which] = snapped(arrow->value + (is_push ? -grown : grown));
        return with_space(document_, state);
    }

    Edit at_cursor(ui::Point at) const
    {
        const double share = (at.x - drawn_.curves.left) / (drawn_.curves.right - drawn_.curves.left);
        return turned_to(std::clamp(-90.0 + 180.0 * share, -90.0, 90.0) * degree);
    }

    Edit at_fibre(ui::Point at) const
    {
        const fm::SectionFigure& figure = s_.section->figure;
        const double y = (drawn_.section.middle - at.y) / drawn_.section.scale;
        const double depth = figure.top() - figure.bottom(), step = is_fine_ ? 1e-3 * depth : round_step(depth / 120.0);
        return with_fibre(document_,
                          std::clamp(rounded(step * std::round(y / step), depth, 6), figure.bottom(), figure.top()));
    }

    /// On the half of the sphere that is seen; beyond its edge the nearest place of the edge.
    Edit on_sphere(ui::Point at) const
    {
        const ui::Point v = (at - drawn_.sphere.middle) / drawn_.sphere.radius;
        const double size = std::max(1.0, ui::length(v)), x = v.x / size, y = -v.y / size;
        const double depth = std::sqrt(std::max(0.0, 1.0 - x * x - y * y));
        const ui::World3 r = drawn_.sphere.eye.right(), u = drawn_.sphere.eye.up(), e = drawn_.sphere.eye.toward_eye();
        std::array<double, 3> n{x * r.x + y * u.x + depth * e.x, x * r.y + y * u.y + depth * e.y,
                                x * r.z + y * u.z + depth * e.z};
        for (double& part : n) part = rounded(part, 1.0, is_fine_ ? 5 : 3);
        return with_normal(document_, n);
    }

    double tidy(double value) const { return rounded(value, frame_.largest, is_fine_ ? 8 : 4); }

    const Document& document_;
    const Solution& s_;
    const Drawn& drawn_;
    const Frame& frame_;
    bool is_fine_;
};

} // namespace

Edit dragged(const Grip& grip, ui::Point at, bool is_fine)
{
    return DragController(grip, is_fine).edit(grip.handle, at);
}

ui::Message label_of(Handle handle)
{
    switch (handle) {
    case Handle::Plane:
    case Handle::Turn:
    case Handle::Cursor:
    case Handle::Normal: return translatable("Turn the plane");
    case Handle::First:
    case Handle::Second:
    case Handle::Third: return translatable("Change the principal values");
    case Handle::Fibre: return translatable("Choose a fibre");
    default: return translatable("Change the state");
    }
}

} // namespace mohr
