#pragma once

#include "ui/paint/label/obstacles.h"

#include <cstdint>
#include <vector>

namespace ui {

/// Marks on a grid of small cells, and how many of them any rectangle of cells holds, in constant time.
/// Source: F. Crow, "Summed-area tables for texture mapping", SIGGRAPH 1984.
class MarkedCells {
public:
    MarkedCells(int n_columns, int n_rows);

    void mark(int x, int y) { sums_[index(x + 1, y + 1)] = 1; }
    /// Call once, after the last mark.
    void sum();
    /// Marks in the columns x0 to x1 and rows y0 to y1, ends included; none where x1 < x0 or y1 < y0.
    std::int32_t n_marks(int x0, int y0, int x1, int y1) const;

private:
    std::size_t index(int x, int y) const { return static_cast<std::size_t>(y * (n_columns_ + 1) + x); }

    int n_columns_;
    int n_rows_;
    std::vector<std::int32_t> sums_; ///< of all marks above and to the left, one row and column larger
};

/// Answers for a fixed set of obstacles what a box would cover: the same answer as theirs, but mostly after a look at
/// a few counts. A box that holds a whole cell which a line runs through covers it; one whose cells no line is near
/// covers none; only between the two the lines themselves are asked.
class ObstacleMap {
public:
    /// \pre the obstacles outlive the map and do not change
    explicit ObstacleMap(const LabelObstacles& obstacles);

    Ground ground_of(const OrientedBox& box) const;

private:
    struct Marks {
        MarkedCells crossed; ///< a line's middle runs through the cell
        MarkedCells near;    ///< some of a line's width may reach into the cell
    };

    void mark(Marks& marks, const LabelObstacles::Segment& segment) const;
    bool is_crossed(const Marks& marks, const Box& box) const;
    bool may_be_crossed(const Marks& marks, const Box& box) const;

    const LabelObstacles& obstacles_;
    Point corner_;
    int n_columns_;
    int n_rows_;
    Marks hard_;
    Marks soft_;
};

} // namespace ui
