#pragma once

#include "ui/paint/geometry.h"

#include <vector>

namespace ui {

/// Remembers where labels looked for a place and found none. What is full only gets fuller, so that after a few of them
/// the next ones there, unless they are smaller, need not look: where a thousand crowd a sheet this spares most work.
class FullCells {
public:
    explicit FullCells(const Box& room);

    /// \pre finite targets
    bool has_no_room(Point target, Size label) const;
    void found_no_room(Point target, Size label);

private:
    struct Cell {
        int n_failed = 0;
        double least_width = 0.0; ///< of those that failed
    };

    std::size_t index(Point target) const;

    Point corner_;
    int n_columns_;
    int n_rows_;
    std::vector<Cell> cells_;
};

} // namespace ui
