#include "apps/cross/view/hint.h"

#include <algorithm>

namespace cross {

namespace {

/// A plus in a ring.
void draw_sign(ui::Painter& painter, ui::Point at, double radius, const ui::Stroke& stroke)
{
    painter.circle(at, radius, stroke);
    const double arm = 0.55 * radius;
    painter.line({at.x - arm, at.y}, {at.x + arm, at.y}, stroke);
    painter.line({at.x, at.y - arm}, {at.x, at.y + arm}, stroke);
}

/// A roller as it would stand there.
void draw_roller(ui::Painter& painter, ui::Point at, double size, const ui::Stroke& stroke)
{
    const ui::Point left{at.x - 0.6 * size, at.y + size}, right{at.x + 0.6 * size, at.y + size};
    painter.line(at, left, stroke);
    painter.line(left, right, stroke);
    painter.line(right, at, stroke);
    painter.line({left.x - 3.0, left.y + 0.35 * size}, {right.x + 3.0, right.y + 0.35 * size}, stroke);
}

/// An arrow that ends there.
void draw_arrow(ui::Painter& painter, ui::Point at, double size, const ui::Stroke& stroke)
{
    painter.line({at.x, at.y - 2.2 * size}, {at.x, at.y - 0.5 * size}, stroke);
    painter.polygon({at, {at.x - 0.35 * size, at.y - 0.8 * size}, {at.x + 0.35 * size, at.y - 0.8 * size}},
                    stroke.color);
}

} // namespace

void draw(ui::Painter& painter, const Hint& hint, const Look& look)
{
    const ui::LayerScope layer(painter, ui::Layer::Overlay);
    const ui::Theme theme = look.full_theme();
    const double scale = theme.symbol_scale();
    ui::Stroke stroke = theme.stroke(hint.is_faint ? ui::Role::GridAxis : ui::Role::Created);
    stroke.width = 1.8 * scale;
    stroke.dash = {};
    if (hint.kind == Hint::Kind::Span) draw_sign(painter, hint.at, 9.0 * scale, stroke);
    else if (hint.kind == Hint::Kind::Load) draw_arrow(painter, hint.at, 14.0 * scale, stroke);
    else draw_roller(painter, hint.at, 12.0 * scale, stroke);
    if (hint.words.empty()) return;
    ui::TextStyle text = theme.text(ui::Role::Label, ui::Anchor::Top);
    text.size = theme.type().small;
    text.plate = theme.background();
    const double half = 0.5 * painter.measure(hint.words, text).width + 4.0;
    const double x = std::max(half, std::min(hint.at.x, painter.size().width - half)); // not beyond the edge
    painter.text({x, hint.at.y + 20.0 * scale}, hint.words, text);
}

} // namespace cross
