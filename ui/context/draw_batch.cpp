#include "ui/context/draw_batch.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ui {

namespace {

PixelBox clip_of(const ImDrawCmd& command, const ImDrawData& data)
{
    const auto whole = [](float v) { return static_cast<int>(std::lround(v)); };
    const PixelBox asked{whole(command.ClipRect.x - data.DisplayPos.x), whole(command.ClipRect.y - data.DisplayPos.y),
                         whole(command.ClipRect.z - data.DisplayPos.x), whole(command.ClipRect.w - data.DisplayPos.y)};
    return common_part(asked, {0, 0, whole(data.DisplaySize.x), whole(data.DisplaySize.y)});
}

/// How many of the command's first indices belong to an opaque rectangle along the axes: 6 or none.
unsigned n_of_background(const ImDrawList& list, const ImDrawCmd& command)
{
    constexpr unsigned n = 6; // of Dear ImGui's rectangle: 0 1 2, 0 2 3
    if (command.ElemCount < n) return 0;
    const auto* const indices = list.IdxBuffer.Data + command.IdxOffset;
    const ImDrawVert* const corners = list.VtxBuffer.Data + command.VtxOffset + indices[0];
    constexpr std::array<unsigned, n> of_rectangle = {0, 1, 2, 0, 2, 3};
    for (unsigned i = 0; i < n; ++i)
        if (indices[i] != indices[0] + of_rectangle[i]) return 0;
    const auto is_like_first = [&](const ImDrawVert& v) {
        return v.col == corners[0].col && v.uv.x == corners[0].uv.x && v.uv.y == corners[0].uv.y;
    };
    const bool is_plain = std::all_of(corners, corners + 4, is_like_first) && corners[0].col >> IM_COL32_A_SHIFT == 255;
    const bool is_level = corners[0].pos.y == corners[1].pos.y && corners[1].pos.x == corners[2].pos.x &&
                          corners[2].pos.y == corners[3].pos.y && corners[3].pos.x == corners[0].pos.x;
    return is_plain && is_level ? n : 0;
}

} // namespace

PixelBox common_part(const PixelBox& a, const PixelBox& b)
{
    return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right), std::min(a.bottom, b.bottom)};
}

std::vector<DrawBatch> batches_of(const ImDrawData& data)
{
    std::vector<DrawBatch> batches;
    for (int k = 0; k < data.CmdListsCount; ++k) {
        const ImDrawList& list = *data.CmdLists[k];
        for (const ImDrawCmd& command : list.CmdBuffer) {
            DrawBatch batch{.list = &list, .first_vertex = command.VtxOffset, .clip = clip_of(command, data)};
            if (command.ElemCount == 0 || batch.clip.is_empty()) continue;
            const unsigned n_first = n_of_background(list, command);
            batch.first_index = command.IdxOffset;
            batch.n_indices = n_first;
            batch.is_blended = false;
            if (n_first > 0) batches.push_back(batch);
            batch.first_index += n_first;
            batch.n_indices = command.ElemCount - n_first;
            batch.is_blended = true;
            batch.image = static_cast<const Image*>(command.GetTexID());
            if (batch.n_indices > 0) batches.push_back(batch);
        }
    }
    return batches;
}

} // namespace ui
