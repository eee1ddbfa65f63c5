#include "apps/cross/view/lock.h"

#include <numbers>

namespace cross {

void draw(drawing::Sketch& sketch, const Lock& lock)
{
    const double w = sketch.px(6.5), h = sketch.px(4.6), r = sketch.px(4.2);
    const ui::Role role = lock.is_shut ? ui::Role::Support : ui::Role::Changed;
    ui::Stroke stroke = sketch.stroke(role);
    stroke.width = sketch.px(1.8);
    stroke.dash = {};
    const ui::Point top = lock.at + ui::Point{0.0, -h - sketch.px(2.2)};
    std::vector<ui::Point> shackle{top + ui::Point{-r, sketch.px(2.2)}};
    constexpr int n = 10;
    for (int i = 0; i <= n; ++i) {
        const double angle = std::numbers::pi * (1.0 - static_cast<double>(i) / n);
        shackle.push_back(top + ui::Point{r * std::cos(angle), -r * std::sin(angle)});
    }
    if (lock.is_shut) shackle.push_back(top + ui::Point{r, sketch.px(2.2)});
    else
        for (ui::Point& p : shackle) p = p + ui::Point{sketch.px(5.0), -sketch.px(2.0)};
    const ui::LayerScope layer(sketch.painter(), ui::Layer::Symbols);
    sketch.polyline(shackle, stroke);
    const ui::Point a = lock.at + ui::Point{-w, -h}, b = lock.at + ui::Point{w, h};
    const std::vector<ui::Point> body{a, {b.x, a.y}, b, {a.x, b.y}};
    sketch.polygon(body, sketch.theme()[role].stroke.color);
    sketch.painter().disc(lock.at, sketch.px(1.5), sketch.theme().background());
}

} // namespace cross
