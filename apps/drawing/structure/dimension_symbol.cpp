#include "apps/drawing/structure/dimension_symbol.h"

namespace drawing {

namespace {

constexpr double reach = 30.0; // [px] of a length from its line: farther off it would seem to belong to something else

void draw_tick(Sketch& sketch, ui::Point at, ui::Point along)
{
    const ui::Point n = ui::left_normal(along);
    const double half = sketch.px(4.0);
    const ui::Stroke stroke = sketch.stroke(ui::Role::Dimension);
    sketch.line(at - 1.5 * half * n, at + 1.5 * half * n, stroke);
    sketch.line(at - half * (n + along), at + half * (n + along), stroke);
}

} // namespace

std::string length_text(const Scene& scene, double length) { return scene.text(length, ui::Measure::Length); }

void draw(const Scene& scene, const DimensionSymbol& symbol)
{
    Sketch& sketch = scene.sketch;
    const ui::Point along = ui::direction(symbol.end - symbol.start);
    sketch.line(symbol.start, symbol.end, sketch.stroke(ui::Role::Dimension));
    draw_tick(sketch, symbol.start, along);
    draw_tick(sketch, symbol.end, along);
    sketch.caption({.text = length_text(scene, symbol.length),
                    .role = ui::Role::Dimension,
                    .target = 0.5 * (symbol.start + symbol.end),
                    .toward = symbol.outward,
                    .gap = 3.0,
                    .rank = Rank::Load,
                    .size = sketch.lesser_value_size(),
                    .reach = reach,
                    .along = along});
}

} // namespace drawing
