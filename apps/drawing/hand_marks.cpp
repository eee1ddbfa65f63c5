#include "apps/drawing/hand_marks.h"

#include <algorithm>
#include <vector>

#include "apps/drawing/grid.h"

namespace drawing {

using ui::Point;
using ui::Role;

void draw_snap(ui::Painter& painter, const ui::Theme& theme, Point p, SnapGlyph glyph)
{
    const double r = 6.0 * theme.symbol_scale();
    const ui::Stroke line{.color = theme.stroke(Role::Member).color, .width = 2.0};
    const Point left_top = p + Point{-r, -r}, right_top = p + Point{r, -r}, right_foot = p + Point{r, r},
                left_foot = p + Point{-r, r};
    switch (glyph) {
    case SnapGlyph::Square:
        painter.polyline({left_top, right_top, right_foot, left_foot}, line, ui::PathEnds::Closed);
        break;
    case SnapGlyph::Cross:
        painter.line(left_top, right_foot, line);
        painter.line(left_foot, right_top, line);
        break;
    case SnapGlyph::Triangle:
        painter.polyline({left_foot, right_foot, p + Point{0.0, -r}}, line, ui::PathEnds::Closed);
        break;
    case SnapGlyph::Corner: painter.polyline({left_top, left_foot, right_foot}, line); break;
    case SnapGlyph::Hourglass:
        painter.polyline({left_top, right_top, left_foot, right_foot}, line, ui::PathEnds::Closed);
        break;
    case SnapGlyph::Plus:
        painter.line(p - Point{r, 0.0}, p + Point{r, 0.0}, line);
        painter.line(p - Point{0.0, r}, p + Point{0.0, r}, line);
        break;
    case SnapGlyph::Circle: painter.circle(p, r, line); break;
    case SnapGlyph::Dot: painter.disc(p, 2.5, line.color); break;
    }
}

ui::TextStyle note_style(const ui::Theme& theme, ui::Anchor anchor)
{
    ui::TextStyle style = theme.text(Role::Label, anchor);
    style.weight = ui::Weight::Bold;
    style.plate = theme.background();
    return style;
}

void draw_note(ui::Painter& painter, const ui::Theme& theme, Point beside, const std::string& text)
{
    ui::TextStyle style = note_style(theme, ui::Anchor::BottomLeft);
    constexpr double away = 14.0; // [px]
    const bool has_room = beside.x + 2.0 * away + painter.measure(text, style).width < painter.size().width;
    if (!has_room) style.anchor = ui::Anchor::BottomRight;
    const double y = std::min(beside.y, painter.size().height) - away;
    painter.text({beside.x + (has_room ? away : -away), y}, text, style);
}

std::string typed_so_far(const std::string& typed) { return typed + "▏"; }

void draw_typed(ui::Painter& painter, const ui::Theme& theme, const std::string& typed)
{
    const ui::LayerScope layer(painter, ui::Layer::Overlay);
    const ui::Size sheet = painter.size();
    painter.text({0.5 * sheet.width, sheet.height - 16.0}, typed_so_far(typed), note_style(theme, ui::Anchor::Bottom));
}

double wide_enough(double step, double scale)
{
    constexpr double nearest = 6.0; // [px]
    while (step * scale < nearest) step *= 10.0;
    return step;
}

void draw_grid(ui::Painter& painter, const ui::Theme& theme, const ui::PlaneCamera& camera, double step)
{
    const ui::LayerScope layer(painter, ui::Layer::Grid);
    step = wide_enough(step, camera.scale());
    const ui::World2 least = camera.to_world({0.0, painter.size().height}),
                     most = camera.to_world({painter.size().width, 0.0});
    const ui::Color ink = ui::with_opacity(theme[Role::FaintLabel].text, 0.4);
    const std::vector<double> rows = multiples_between(least.y, most.y, step);
    for (const double x : multiples_between(least.x, most.x, step))
        for (const double y : rows) {
            const Point p = camera.to_sheet({x, y});
            painter.rectangle({p - Point{0.75, 0.75}, p + Point{0.75, 0.75}}, ink);
        }
}

} // namespace drawing
