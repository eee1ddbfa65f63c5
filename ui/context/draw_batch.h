#pragma once

#include "ui/context/context.h"

#include <vector>

struct ImDrawData;
struct ImDrawList;

namespace ui {

struct Image;

/// Pixels of a picture with left <= x < right and top <= y < bottom, counted from its top left corner.
struct PixelBox {
    int left = 0, top = 0, right = 0, bottom = 0;

    bool is_empty() const { return left >= right || top >= bottom; }
    friend bool operator==(const PixelBox&, const PixelBox&) = default;
};

/// The pixels that lie in both.
PixelBox common_part(const PixelBox& a, const PixelBox& b);

/// Triangles of one draw list that are drawn alike, one after the other.
struct DrawBatch {
    const ImDrawList* list = nullptr;
    unsigned first_index = 0;
    unsigned n_indices = 0;    ///< three of each triangle
    unsigned first_vertex = 0; ///< is added to each index
    PixelBox clip{};
    const Image* image = nullptr; ///< none where lines and areas alone are drawn
    bool is_blended = true;
};

/// What the lists draw, in order. A window's opaque background is a batch of its own that needs neither image nor
/// blending: a software renderer fills it several times faster.
/// \pre no command calls back
std::vector<DrawBatch> batches_of(const ImDrawData& data);

} // namespace ui
