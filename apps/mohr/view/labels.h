#pragma once

#include <string>
#include <vector>

#include "ui/paint/label_placement.h"
#include "ui/paint/theme.h"

namespace mohr {

/// Words that want a place near what they speak of; they are drawn once all is known: none over another, nor over a line
/// that was drawn before, unless there is no room elsewhere; then on a ground of their own.
class Labels {
public:
    Labels(const ui::Box& room, const ui::Fonts& fonts) : placer_({.room = room}), fonts_(fonts) {}

    ui::LabelObstacles& obstacles() { return placer_.obstacles(); }
    /// \param away  where it had best stand, seen from the target
    void add(ui::Point target, ui::Point away, std::string text, const ui::TextStyle& style, double priority = 0.0);
    /// Words that belong right there, such as an axis's number: in one of a few places near the target, chosen before
    /// all others. \param sides  from the target to the nearest point of the words, best first; of no length: about it
    void add_fixed(ui::Point target, const std::vector<ui::Point>& sides, std::string text, const ui::TextStyle& style,
                   double priority = 0.0);
    void draw(ui::Painter& painter, const ui::Theme& theme);

private:
    struct Words {
        std::string text;
        ui::TextStyle style;
    };
    /// Words of one kind, and where they may stand.
    struct Group {
        std::vector<ui::Label> labels;
        std::vector<Words> words;
    };
    void keep_clear_of(const ui::Picture& picture, const ui::Theme& theme);
    void draw(const Group& group, ui::Painter& painter, const ui::Theme& theme);

    ui::LabelPlacer placer_;
    const ui::Fonts& fonts_;
    Group fixed_, free_;
};

} // namespace mohr
