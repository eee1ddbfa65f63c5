#include "ui/paint/label/obstacle_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/paint/label/cells.h"

namespace ui {

namespace {

constexpr double map_cell_side = 6.0; // [px]: a line of type holds one whole cell at least
constexpr double most_map_cells = 4096.0;

/// The cell that a coordinate lies in; that beside the grid for what lies outside.
int cell_at(double place, int n)
{
    return static_cast<int>(std::clamp(std::floor(place / map_cell_side), -1.0, static_cast<double>(n)));
}

/// The first and the last cell that lie as a whole between two coordinates.
int first_whole(double place) { return static_cast<int>(std::ceil(place / map_cell_side)); }
int last_whole(double place) { return static_cast<int>(std::floor(place / map_cell_side)) - 1; }

/// The part of a segment between two levels, as a range of x; empty (first > second) where there is none.
std::pair<double, double> range_between(Point a, Point b, double y0, double y1)
{
    if (std::max(a.y, b.y) < y0 || std::min(a.y, b.y) > y1) return {1.0, 0.0};
    if (a.y == b.y) return std::minmax({a.x, b.x});
    const auto at = [&](double y) { return a.x + (b.x - a.x) * std::clamp((y - a.y) / (b.y - a.y), 0.0, 1.0); };
    return std::minmax({at(y0), at(y1)});
}

} // namespace

MarkedCells::MarkedCells(int n_columns, int n_rows)
    : n_columns_(n_columns),
      n_rows_(n_rows),
      sums_(static_cast<std::size_t>(n_columns + 1) * static_cast<std::size_t>(n_rows + 1))
{}

void MarkedCells::sum()
{
    for (int y = 1; y <= n_rows_; ++y) {
        std::int32_t row = 0;
        for (int x = 1; x <= n_columns_; ++x) {
            row += sums_[index(x, y)];
            sums_[index(x, y)] = sums_[index(x, y - 1)] + row;
        }
    }
}

std::int32_t MarkedCells::n_marks(int x0, int y0, int x1, int y1) const
{
    const int left = std::max(x0, 0), top = std::max(y0, 0);
    const int right = std::min(x1, n_columns_ - 1) + 1, bottom = std::min(y1, n_rows_ - 1) + 1;
    if (right <= left || bottom <= top) return 0;
    return sums_[index(right, bottom)] - sums_[index(left, bottom)] - sums_[index(right, top)] +
           sums_[index(left, top)];
}

ObstacleMap::ObstacleMap(const LabelObstacles& obstacles)
    : obstacles_(obstacles),
      corner_(obstacles.room_.min),
      n_columns_(n_cells(obstacles.room_.width(), map_cell_side, most_map_cells)),
      n_rows_(n_cells(obstacles.room_.height(), map_cell_side, most_map_cells)),
      hard_{{n_columns_, n_rows_}, {n_columns_, n_rows_}},
      soft_{{n_columns_, n_rows_}, {n_columns_, n_rows_}}
{
    for (const auto& segment : obstacles.segments_) mark(segment.firmness == Firmness::Hard ? hard_ : soft_, segment);
    for (MarkedCells* cells : {&hard_.crossed, &hard_.near, &soft_.crossed, &soft_.near}) cells->sum();
}

void ObstacleMap::mark(Marks& marks, const LabelObstacles::Segment& segment) const
{
    const Point a = segment.a - corner_, b = segment.b - corner_;
    const double reach = segment.half_width;
    const int first = std::max(cell_at(std::min(a.y, b.y) - reach, n_rows_), 0);
    const int last = std::min(cell_at(std::max(a.y, b.y) + reach, n_rows_), n_rows_ - 1);
    const auto mark_range = [&](MarkedCells& cells, std::pair<double, double> range, double more, int y) {
        if (range.first > range.second) return;
        const int from = std::max(cell_at(range.first - more, n_columns_), 0);
        const int to = std::min(cell_at(range.second + more, n_columns_), n_columns_ - 1);
        for (int x = from; x <= to; ++x) cells.mark(x, y);
    };
    for (int y = first; y <= last; ++y) {
        const double top = y * map_cell_side, bottom = top + map_cell_side;
        mark_range(marks.crossed, range_between(a, b, top, bottom), 0.0, y);
        mark_range(marks.near, range_between(a, b, top - reach, bottom + reach), reach, y);
    }
}

bool ObstacleMap::is_crossed(const Marks& marks, const Box& box) const
{
    return marks.crossed.n_marks(first_whole(box.min.x - corner_.x), first_whole(box.min.y - corner_.y),
                                 last_whole(box.max.x - corner_.x), last_whole(box.max.y - corner_.y)) > 0;
}

bool ObstacleMap::may_be_crossed(const Marks& marks, const Box& box) const
{
    return marks.near.n_marks(cell_at(box.min.x - corner_.x, n_columns_), cell_at(box.min.y - corner_.y, n_rows_),
                              cell_at(box.max.x - corner_.x, n_columns_), cell_at(box.max.y - corner_.y, n_rows_)) > 0;
}

Ground ObstacleMap::ground_of(const OrientedBox& box) const
{
    const Box bounds = box.bounds();
    if (box.is_level() && is_crossed(hard_, bounds)) return Ground::Taken;
    if (may_be_crossed(hard_, bounds)) return obstacles_.ground_of(box);
    const Ground inside = obstacles_.ground_inside(box.center);
    if (inside != Ground::Free || !may_be_crossed(soft_, bounds)) return inside;
    return box.is_level() && is_crossed(soft_, bounds) ? Ground::Soft : obstacles_.ground_of(box);
}

} // namespace ui
