#pragma once

#include <string>
#include <vector>

#include "ui/paint/label_placement.h"
#include "ui/paint/theme.h"

namespace mohr {

/// Words that want a place near what they speak of; they are drawn once all are known, none over another.
class Labels {
public:
    Labels(const ui::Box& room, const ui::Fonts& fonts) : placer_({.room = room}), fonts_(fonts) {}

    ui::LabelObstacles& obstacles() { return placer_.obstacles(); }
    /// \param away  where it had best stand, seen from the target
    void add(ui::Point target, ui::Point away, std::string text, const ui::TextStyle& style, double priority = 0.0);
    void draw(ui::Painter& painter, const ui::Stroke& leader, ui::Color plate) const;

private:
    struct Words {
        std::string text;
        ui::TextStyle style;
    };
    ui::LabelPlacer placer_;
    const ui::Fonts& fonts_;
    std::vector<ui::Label> labels_;
    std::vector<Words> words_;
};

} // namespace mohr
