#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "ui/paint/label_placement.h"
#include "ui/paint/theme.h"

namespace mohr {

/// Words that want a place near what they speak of; they are drawn once all is known: none over another, nor over a line
/// that was drawn before, unless there is no room elsewhere; then on a ground of their own. Where some of them have no
/// place at all the least important ones are left out, and what says a number is rather small than left out.
class Labels {
public:
    Labels(const ui::Box& room, const ui::Fonts& fonts) : placer_({.room = room}), fonts_(fonts) {}

    ui::LabelObstacles& obstacles() { return placer_.obstacles(); }
    /// What words speak of, and where they had best stand, seen from it.
    struct Place {
        ui::Point target, away;
    };
    /// \param away  where it had best stand, seen from the target
    /// \param priority  of `least_number` or more: a number that would be missed
    /// \param others  which it speaks of as well: beside one of them rather than far from the target
    void add(ui::Point target, ui::Point away, std::string text, const ui::TextStyle& style, double priority = 0.0,
             std::vector<Place> others = {});
    /// Words that belong right there, such as an axis's number: in one of a few places near the target, chosen before
    /// all others. \param sides  from the target to the nearest point of the words, best first; of no length: about it
    void add_fixed(ui::Point target, const std::vector<ui::Point>& sides, std::string text, const ui::TextStyle& style,
                   double priority = 0.0);
    void draw(ui::Painter& painter, const ui::Theme& theme);
    static constexpr double least_number = 3.0;

private:
    struct Words {
        std::string text;
        ui::TextStyle style;
    };
    /// Words that want to stand about a point, or about one of others.
    struct Wish {
        Place place;
        Words words;
        double priority = 0.0;
        std::vector<Place> others;
    };
    /// Words of one kind, and where they may stand.
    struct Group {
        std::vector<ui::Label> labels;
        std::vector<Words> words;
    };
    void keep_clear_of(const ui::Picture& picture, const ui::Theme& theme);
    ui::Label label(const Wish& wish) const;
    Group free_group(double largest) const;
    Group with_room(Group group) const;
    bool has_place_alone(const ui::Label& label) const;
    std::size_t n_numbers_placed(const Group& group) const;
    Group free_with_room(double small) const;
    void draw(const Group& group, ui::Painter& painter, const ui::Theme& theme);

    ui::LabelPlacer placer_;
    const ui::Fonts& fonts_;
    Group fixed_;
    std::vector<Wish> free_;
};

} // namespace mohr
