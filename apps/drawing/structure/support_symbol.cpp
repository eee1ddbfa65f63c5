#include "apps/drawing/structure/support_symbol.h"

#include <numbers>
#include <vector>

namespace drawing {

namespace {

using femoop::Dof;
using femoop::DofSet;
using std::numbers::pi;

void draw_triangle(Sketch& sketch, const SymbolFrame& f, double half, double height)
{
    const std::vector<ui::Point> corners{f(0.0, 0.0), f(-half, -height), f(half, -height)};
    sketch.polygon(corners, sketch.theme().fill(ui::Role::Support));
    sketch.polyline(corners, sketch.stroke(ui::Role::Support), Clearance::Hard, ui::PathEnds::Closed);
}

void draw_rollers(Sketch& sketch, const SymbolFrame& f, double depth, int count)
{
    const double r = sketch.px(3.0);
    for (int i = 0; i < count; ++i) {
        const double x = (i - 0.5 * (count - 1)) * 2.6 * r;
        sketch.disc(f(x, -depth - r), r, sketch.theme().background());
        sketch.ring(f(x, -depth - r), r, sketch.thin(ui::Role::Support));
    }
    draw_ground(sketch, f.moved(0.0, -depth - 2.0 * r), sketch.px(15.0));
}

void draw_plate(Sketch& sketch, const SymbolFrame& f, double half)
{
    ui::Stroke stroke = sketch.stroke(ui::Role::Support);
    stroke.width *= 2.2;
    sketch.line(f(-half, 0.0), f(half, 0.0), stroke);
}

void draw_slider(Sketch& sketch, const SymbolFrame& f)
{
    draw_plate(sketch, f, sketch.px(14.0));
    draw_rollers(sketch, f, sketch.px(2.0), 3);
}

// A plate on rollers on a plate on rollers: it moves both ways and does not turn.
void draw_double_slider(Sketch& sketch, const SymbolFrame& f)
{
    const double depth = sketch.px(10.0);
    draw_plate(sketch, f, sketch.px(11.0));
    const double r = sketch.px(3.0);
    for (const double x : {-1.5, 1.5}) sketch.ring(f(x * r, -sketch.px(2.0) - r), r, sketch.thin(ui::Role::Support));
    const SymbolFrame block = f.moved(0.0, -depth);
    const double half = sketch.px(11.0);
    const double h = sketch.px(14.0);
    const std::vector<ui::Point> corners{block(-half, 0.0), block(half, 0.0), block(half, -h), block(-half, -h)};
    sketch.polygon(corners, sketch.theme().fill(ui::Role::Support));
    sketch.polyline(corners, sketch.stroke(ui::Role::Support), Clearance::Hard, ui::PathEnds::Closed);
    const SymbolFrame wall = block.moved(half, -0.5 * h).turned(pi / 2);
    for (const double x : {-1.3, 1.3}) sketch.ring(wall(x * r, -r), r, sketch.thin(ui::Role::Support));
    draw_ground(sketch, wall.moved(0.0, -2.0 * r), sketch.px(11.0));
}

} // namespace

SupportSymbol support_symbol(DofSet blocked)
{
    const bool x = blocked.contains(Dof::ux);
    const bool y = blocked.contains(Dof::uy);
    const bool turn = blocked.contains(Dof::rz);
    if (x && y) return turn ? SupportSymbol::Wall : SupportSymbol::Pin;
    if (x) return turn ? SupportSymbol::SliderX : SupportSymbol::RollerX;
    if (y) return turn ? SupportSymbol::SliderY : SupportSymbol::RollerY;
    return turn ? SupportSymbol::NoRotation : SupportSymbol::None;
}

void draw(Sketch& sketch, SupportSymbol symbol, const SymbolFrame& f)
{
    const double half = sketch.px(10.0);
    const double height = sketch.px(17.0);
    switch (symbol) {
    case SupportSymbol::None: return;
    case SupportSymbol::Wall: return draw_ground(sketch, f, sketch.px(16.0));
    case SupportSymbol::Pin:
        draw_triangle(sketch, f, half, height);
        return draw_ground(sketch, f.moved(0.0, -height), sketch.px(15.0));
    case SupportSymbol::RollerX:
    case SupportSymbol::RollerY:
        draw_triangle(sketch, f, half, 0.8 * height);
        return draw_rollers(sketch, f, 0.8 * height, 3);
    case SupportSymbol::SliderX:
    case SupportSymbol::SliderY: return draw_slider(sketch, f);
    case SupportSymbol::NoRotation: return draw_double_slider(sketch, f);
    }
}

} // namespace drawing
