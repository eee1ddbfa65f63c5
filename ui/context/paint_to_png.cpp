#include "ui/context/paint_to_png.h"

#include "ui/context/rasterize.h"

namespace ui {

void paint_to_png(const std::filesystem::path& path, const Sheet& sheet, const Drawing& drawing)
{
    const Fonts fonts;
    const Picture picture = painted(sheet, fonts, drawing);
    write_png(path, rasterized(picture, fonts, {.scale = sheet.scale, .background = sheet.background}));
}

} // namespace ui
