#include "apps/mohr/view/arrow.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mohr {

namespace {

void arrow_head(ui::Painter& painter, ui::Point tip, ui::Point along, double head, ui::Color color)
{
    const ui::Point side = 0.38 * head * ui::left_normal(along), back = tip - head * along;
    painter.polygon({tip, back + side, back - side}, color);
}

} // namespace

ui::Stroke solid(ui::Stroke stroke)
{
    stroke.dash = {};
    return stroke;
}

void arrow(ui::Painter& painter, ui::Point from, ui::Point to, const ui::Stroke& stroke, double head)
{
    const double length = ui::distance(from, to);
    if (!(length > 0.5)) return;
    const ui::Point along = (to - from) / length;
    const double size = std::min(head, 0.8 * length);
    painter.line(from, to - 0.8 * size * along, stroke);
    arrow_head(painter, to, along, size, stroke.color);
}

void arc_arrow(ui::Painter& painter, const ui::Arc& arc, const ui::Stroke& stroke, double head)
{
    const double length = std::abs(arc.sweep) * arc.radius;
    if (!(length > 1.0)) return;
    const double size = std::min(head, 0.6 * length);
    const double sense = arc.sweep > 0.0 ? 1.0 : -1.0;
    ui::Arc line = arc;
    line.sweep -= sense * 0.8 * size / arc.radius;
    painter.arc(line, stroke);
    const double end = arc.start + arc.sweep, chord = end + sense * (0.5 * std::numbers::pi - 0.5 * size / arc.radius);
    arrow_head(painter, arc.at(end), {std::cos(chord), -std::sin(chord)}, size, stroke.color);
}

} // namespace mohr
