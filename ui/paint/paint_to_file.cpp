#include "ui/paint/paint_to_file.h"

#include "ui/paint/surface/golden_text.h"
#include "ui/paint/surface/pdf.h"
#include "ui/paint/surface/svg.h"
#include "ui/paint/surface/write_file.h"

#include <stdexcept>

namespace ui {

namespace {

constexpr double largest_side = 16384.0;

bool is_side(double pixels)
{
    return pixels >= 1.0 && pixels <= largest_side; // false for NaN
}

void require_area(const Sheet& sheet)
{
    const Size physical = sheet.scale * sheet.size;
    if (!is_side(sheet.size.width) || !is_side(sheet.size.height) || !is_side(physical.width) ||
        !is_side(physical.height))
        throw std::invalid_argument("sheet of " + std::to_string(sheet.size.width) + " x " +
                                    std::to_string(sheet.size.height) + " at scale " + std::to_string(sheet.scale) +
                                    ": each side must have from 1 to 16384 pixels");
}

} // namespace

Picture painted(const Sheet& sheet, const Fonts& fonts, const Drawing& drawing)
{
    require_area(sheet);
    Painter painter(sheet.size, fonts);
    drawing(painter);
    return painter.picture();
}

void paint_to_svg(const std::filesystem::path& path, const Sheet& sheet, const Drawing& drawing)
{
    const Fonts fonts;
    const Picture picture = painted(sheet, fonts, drawing);
    write_file(path, svg_document(picture, fonts, sheet.background));
}

void paint_to_pdf(const std::filesystem::path& path, const Sheet& sheet, const Drawing& drawing)
{
    const Fonts fonts;
    write_pdf(path, painted(sheet, fonts, drawing), fonts, {.background = sheet.background, .title = sheet.title});
}

std::string paint_to_text(const Sheet& sheet, const Drawing& drawing)
{
    const Fonts fonts;
    return golden_text(painted(sheet, fonts, drawing));
}

} // namespace ui
