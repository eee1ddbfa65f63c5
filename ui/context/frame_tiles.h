#pragma once

#include "ui/context/draw_batch.h"
#include "ui/paint/color.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ui {

/// Knows in which part of the picture a frame differs from the one before, so that this part alone is drawn again: a
/// renderer in software would spend most of its time on pixels that stay as they are.
///
/// The picture is divided into square tiles. All that is drawn over a tile, in its order, goes into one number of 64
/// bits; while the number stays, so do the pixels. Tiles that differ are joined into boxes.
class FrameTiles {
public:
    static constexpr int side = 32; ///< of a tile [px]

    /// Compares a frame with the one before. The first one, or one of another size, differs everywhere.
    void compare(std::span<const DrawBatch> batches, PixelSize size, Color background);

    /// Where the frame differs; no box lies over another.
    std::span<const PixelBox> boxes() const { return boxes_; }

    /// For each box the vertices of those of the batch's triangles that it needs, as places in the batch's list.
    /// Valid until the next call.
    std::span<const std::vector<unsigned>> triangles_by_box(const DrawBatch& batch);

private:
    void join_changed(const std::vector<std::uint64_t>& drawn);

    PixelSize size_{};
    int n_columns_ = 0, n_rows_ = 0;
    std::vector<std::uint64_t> tiles_; ///< of the frame compared last, row by row
    std::vector<PixelBox> boxes_;
    std::vector<std::size_t> box_of_tile_; ///< the last number there is where nothing differs
    std::vector<std::vector<unsigned>> triangles_by_box_;
};

} // namespace ui
