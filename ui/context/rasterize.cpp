#include "ui/context/rasterize.h"

#include "ui/context/draw_list_renderer.h"
#include "ui/context/draw_list_surface.h"
#include "ui/context/offscreen.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <cmath>

namespace ui {

namespace {

int whole(double pixels) { return static_cast<int>(std::lround(pixels)); }

} // namespace

Pixels rasterized(const Picture& picture, const Fonts& fonts, const Raster& raster)
{
    const Size physical = raster.scale * picture.size();
    Offscreen context({.size = {whole(physical.width), whole(physical.height)}, .scale = raster.scale});
    DrawListRenderer renderer(context);
    GlyphAtlas atlas(fonts);
    ImDrawListSharedData shared;
    const ImVec2 size(static_cast<float>(context.size().width), static_cast<float>(context.size().height));
    shared.InitialFlags = ImDrawListFlags_AllowVtxOffset;
    shared.ClipRectFullscreen = {0.0F, 0.0F, size.x, size.y};
    ImDrawList list(&shared);
    list._ResetForNewFrame();
    list.PushClipRectFullScreen();
    {
        DrawListSurface surface(list, atlas, {.origin = {}, .scale = raster.scale});
        picture.draw_on(surface);
    }
    ImDrawList* lists = &list;
    ImDrawData data;
    data.Valid = true;
    data.CmdLists = &lists;
    data.CmdListsCount = 1;
    data.DisplaySize = size;
    data.FramebufferScale = {1.0F, 1.0F};
    renderer.render(data, raster.background);
    return context.pixels();
}

} // namespace ui
