#include "ui/paint/label/full_cells.h"

#include <algorithm>
#include <cmath>

#include "ui/paint/label/cells.h"

namespace ui {

namespace {

constexpr int enough = 4;               // labels that found no room, for the next one to believe it
constexpr double full_cell_side = 40.0; // [px]: about as far as a label stands from its target
constexpr double most_full_cells = 512.0;

} // namespace

FullCells::FullCells(const Box& room)
    : corner_(room.min),
      n_columns_(n_cells(room.width(), full_cell_side, most_full_cells)),
      n_rows_(n_cells(room.height(), full_cell_side, most_full_cells)),
      cells_(static_cast<std::size_t>(n_columns_) * static_cast<std::size_t>(n_rows_))
{}

// Targets outside the room are counted to the cells along its border.
std::size_t FullCells::index(Point target) const
{
    const auto at = [](double place, int n) {
        return static_cast<std::size_t>(
            std::clamp(std::floor(place / full_cell_side), 0.0, static_cast<double>(n - 1)));
    };
    return at(target.y - corner_.y, n_rows_) * static_cast<std::size_t>(n_columns_) +
           at(target.x - corner_.x, n_columns_);
}

bool FullCells::has_no_room(Point target, Size label) const
{
    const Cell& cell = cells_[index(target)];
    return cell.n_failed >= enough && label.width >= cell.least_width;
}

void FullCells::found_no_room(Point target, Size label)
{
    Cell& cell = cells_[index(target)];
    cell.least_width = cell.n_failed == 0 ? label.width : std::min(cell.least_width, label.width);
    ++cell.n_failed;
}

} // namespace ui
