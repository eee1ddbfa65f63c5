#include "ui/context/frame_tiles.h"

#include "ui/paint/image.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

namespace ui {

namespace {

constexpr std::size_t no_box = static_cast<std::size_t>(-1);

std::uint64_t mixed_in(std::uint64_t hash, std::uint64_t value)
{
    constexpr std::uint64_t odd = 0x9E3779B97F4A7C15; // 2^64 over the golden ratio
    hash = (hash ^ value) * odd;
    return hash ^ (hash >> 32);
}

std::uint64_t hash_of(const ImDrawVert& vertex)
{
    static_assert(sizeof(vertex.pos) == sizeof(std::uint64_t) && sizeof(vertex.uv) == sizeof(std::uint64_t));
    std::uint64_t pos = 0, uv = 0;
    std::memcpy(&pos, &vertex.pos, sizeof pos);
    std::memcpy(&uv, &vertex.uv, sizeof uv);
    return mixed_in(mixed_in(vertex.col, pos), uv);
}

std::uint64_t pair_of(int high, int low)
{
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(high)) << 32 | static_cast<std::uint32_t>(low);
}

/// Of how a batch's triangles are drawn, whichever they are.
std::uint64_t hash_of(const DrawBatch& batch)
{
    std::uint64_t hash = mixed_in(batch.is_blended ? 1 : 2, pair_of(batch.clip.left, batch.clip.top));
    hash = mixed_in(hash, pair_of(batch.clip.right, batch.clip.bottom));
    if (!batch.image) return hash;
    return mixed_in(mixed_in(hash, reinterpret_cast<std::uintptr_t>(batch.image)), batch.image->version);
}

/// Calls `visit` with the places in the list of each triangle's vertices.
template <class Visit> void for_each_triangle(const DrawBatch& batch, const Visit& visit)
{
    const ImDrawIdx* const indices = batch.list->IdxBuffer.Data + batch.first_index;
    for (unsigned i = 0; i + 2 < batch.n_indices; i += 3)
        visit(std::array{batch.first_vertex + indices[i], batch.first_vertex + indices[i + 1],
                         batch.first_vertex + indices[i + 2]});
}

/// The pixels that a triangle may cover.
PixelBox pixels_of(const DrawBatch& batch, const std::array<unsigned, 3>& triangle)
{
    const ImDrawVert* const vertices = batch.list->VtxBuffer.Data;
    const ImVec2 a = vertices[triangle[0]].pos, b = vertices[triangle[1]].pos, c = vertices[triangle[2]].pos;
    const auto [left, right] = std::minmax({a.x, b.x, c.x});
    const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
    const PixelBox& clip = batch.clip;
    const auto inside = [](float v, int from, int to) {
        return static_cast<int>(std::clamp(v, static_cast<float>(from), static_cast<float>(to)));
    };
    const bool is_seen = right >= static_cast<float>(clip.left) && left <= static_cast<float>(clip.right) &&
                         bottom >= static_cast<float>(clip.top) && top <= static_cast<float>(clip.bottom);
    if (!is_seen) return {}; // nor is one with a place that is no number
    return common_part(clip, {inside(left, clip.left, clip.right), inside(top, clip.top, clip.bottom),
                              inside(right, clip.left, clip.right) + 1, inside(bottom, clip.top, clip.bottom) + 1});
}

/// Calls `visit` with the number of each tile that the box meets.
template <class Visit> void for_each_tile(const PixelBox& box, int n_columns, const Visit& visit)
{
    if (box.is_empty()) return;
    constexpr int side = FrameTiles::side;
    for (int row = box.top / side; row <= (box.bottom - 1) / side; ++row)
        for (int column = box.left / side; column <= (box.right - 1) / side; ++column)
            visit(static_cast<std::size_t>(row * n_columns + column));
}

} // namespace

void FrameTiles::compare(std::span<const DrawBatch> batches, PixelSize size, Color background)
{
    const bool is_comparable = size == size_;
    size_ = size;
    n_columns_ = (size.width + side - 1) / side;
    n_rows_ = (size.height + side - 1) / side;
    const std::vector<std::uint64_t> drawn = is_comparable ? std::move(tiles_) : std::vector<std::uint64_t>();
    const std::uint64_t empty = pair_of(background.r << 8 | background.g, background.b << 8 | background.a);
    tiles_.assign(static_cast<std::size_t>(n_columns_) * static_cast<std::size_t>(n_rows_), empty);

    const ImDrawList* list = nullptr;
    std::vector<std::uint64_t> vertices;
    for (const DrawBatch& batch : batches) {
        if (batch.list != list) {
            list = batch.list;
            vertices.resize(static_cast<std::size_t>(list->VtxBuffer.Size));
            std::transform(list->VtxBuffer.begin(), list->VtxBuffer.end(), vertices.begin(),
                           [](const ImDrawVert& vertex) { return hash_of(vertex); });
        }
        const std::uint64_t look = hash_of(batch);
        for_each_triangle(batch, [&](const std::array<unsigned, 3>& triangle) {
            std::uint64_t hash = look;
            for (const unsigned vertex : triangle) hash = mixed_in(hash, vertices[vertex]);
            for_each_tile(pixels_of(batch, triangle), n_columns_,
                          [&](std::size_t tile) { tiles_[tile] = mixed_in(tiles_[tile], hash); });
        });
    }
    join_changed(drawn);
}

/// A row's changed tiles that touch are a box; it goes on through the rows below while they have the same ones.
void FrameTiles::join_changed(const std::vector<std::uint64_t>& drawn)
{
    boxes_.clear();
    box_of_tile_.assign(tiles_.size(), no_box);
    const auto is_changed = [&](std::size_t tile) { return drawn.empty() || drawn[tile] != tiles_[tile]; };
    for (int row = 0; row < n_rows_; ++row) {
        const auto tile_at = [&](int column) { return static_cast<std::size_t>(row * n_columns_ + column); };
        for (int begin = 0; begin < n_columns_; ++begin) {
            if (!is_changed(tile_at(begin))) continue;
            int end = begin + 1;
            while (end < n_columns_ && is_changed(tile_at(end))) ++end;
            const PixelBox run{begin * side, row * side, std::min(end * side, size_.width),
                               std::min((row + 1) * side, size_.height)};
            const std::size_t above = row > 0 ? box_of_tile_[tile_at(begin) - static_cast<std::size_t>(n_columns_)]
                                              : no_box;
            const bool goes_on = above != no_box && boxes_[above].left == run.left && boxes_[above].right == run.right;
            const std::size_t box = goes_on ? above : boxes_.size();
            if (goes_on) boxes_[box].bottom = run.bottom;
            else boxes_.push_back(run);
            std::fill_n(box_of_tile_.begin() + static_cast<std::ptrdiff_t>(tile_at(begin)), end - begin, box);
            begin = end;
        }
    }
}

std::span<const std::vector<unsigned>> FrameTiles::triangles_by_box(const DrawBatch& batch)
{
    triangles_by_box_.resize(boxes_.size());
    if (boxes_.empty()) return {};
    for (std::vector<unsigned>& triangles : triangles_by_box_) triangles.clear();
    std::vector<unsigned> last_of_box(boxes_.size()); // the triangles, counted from 1
    unsigned n = 0;
    for_each_triangle(batch, [&](const std::array<unsigned, 3>& triangle) {
        ++n;
        for_each_tile(pixels_of(batch, triangle), n_columns_, [&](std::size_t tile) {
            const std::size_t box = box_of_tile_[tile];
            if (box == no_box || std::exchange(last_of_box[box], n) == n) return;
            triangles_by_box_[box].insert(triangles_by_box_[box].end(), triangle.begin(), triangle.end());
        });
    });
    return triangles_by_box_;
}

} // namespace ui
