#include "apps/mohr/view/labels.h"

#include <array>
#include <cmath>
#include <numbers>

namespace mohr {

void Labels::add(ui::Point target, ui::Point away, std::string text, const ui::TextStyle& style, double priority)
{
    const ui::Size size = ui::label_size(fonts_, text, style);
    ui::Label label{.target = target, .size = size, .priority = priority};
    const double start = std::atan2(away.y, away.x);
    for (const double turn : {0.0, 0.6, -0.6, 1.2, -1.2, 1.9, -1.9, 2.6, -2.6}) {
        const ui::Point along{std::cos(start + turn), std::sin(start + turn)};
        label.wishes.push_back(target +
                               ui::Point{along.x * (0.5 * size.width + 8.0), along.y * (0.5 * size.height + 8.0)});
    }
    labels_.push_back(std::move(label));
    words_.push_back({std::move(text), style});
}

void Labels::draw(ui::Painter& painter, const ui::Stroke& leader, ui::Color plate) const
{
    const ui::LayerScope layer(painter, ui::Layer::Labels);
    const ui::LabelPlacement placed = placer_.place(labels_);
    for (std::size_t i = 0; i < labels_.size(); ++i) {
        const auto& place = placed.labels[i];
        if (!place) continue;
        if (place->leader) painter.line(place->leader->from, place->leader->to, leader);
        ui::TextStyle style = words_[i].style;
        if (place->is_over_soft) style.plate = ui::with_opacity(plate, 0.8);
        ui::draw_label(painter, *place, words_[i].text, style);
    }
}

} // namespace mohr
