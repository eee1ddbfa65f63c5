#pragma once

#include <string>
#include <vector>

#include "apps/cross/view/block_layout.h"
#include "apps/cross/view/panels.h"

namespace cross {

/// Where the columns of a sheet may stand on the structure's sketch.

EndPlace place_of_end(const Panel& panel, const drawing::StructureShape& shape, const femoop::cross::Problem& problem,
                      femoop::cross::EndId end, const ui::Theme& theme);
/// The members, as chains of small boxes.
std::vector<ui::Box> walls_in(const Panel& panel, const drawing::StructureShape& shape);
/// What they must leave free: members, joints, supports.
std::vector<ui::Box> obstacles_in(const Panel& panel, const drawing::StructureShape& shape, const femoop::Model& model,
                                  const ui::Theme& theme);
/// Half the breadth of a support, of which columns keep off [px].
double support_reach(const ui::Theme& theme);
ui::Point middle_of(const Panel& panel, const drawing::StructureShape& shape);

/// The name of a member end as broad as its column lets it be: long names of nodes are shortened, "Apo…-Nó…".
std::string head_within(const ui::Painter& painter, const femoop::Model& model, const femoop::cross::End& end,
                        const ui::TextStyle& style, double width);

/// Where a panel's columns are seen whole, below its title.
ui::Box sight_below(const ui::Box& title, const Panel& panel, const ui::Theme& theme);
/// How far a box is to be moved so that it lies within another; nothing where it does. Of one that is too large its top
/// left is seen.
std::optional<ui::Point> way_into_sight(const ui::Box& box, const ui::Box& sight);

/// The box around a warning at the lower right of a panel. \pre it has words
ui::Box box_below(const ui::Painter& painter, const Panel& panel, const ui::Theme& theme, const std::string& words);
/// Writes it there.
void write_below(ui::Painter& painter, const Panel& panel, const ui::Theme& theme, const std::string& words);

} // namespace cross
