#include "apps/cli/picture_file.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <system_error>

#include "apps/cli/argument.h"
#include "apps/cli/output_file.h"
#include "ui/context/paint_to_png.h"

namespace cli {

namespace {

constexpr long smallest_side = 64, largest_side = 16384; // pixels
constexpr double largest_scale = 8.0;

ui::Size size_of(const std::string& text, const ui::Catalogue& tr)
{
    const std::size_t times = text.find('x');
    if (times == std::string::npos)
        throw UsageError(
            tr("--size: found {found}; wanted width and height, such as 1280x800", {{"found", "\"" + text + "\""}}));
    const WholeRange range{smallest_side, largest_side};
    return {static_cast<double>(whole_number("--size", text.substr(0, times), range, tr)),
            static_cast<double>(whole_number("--size", text.substr(times + 1), range, tr))};
}

/// Both readings of "scale" are common; the other one has an option of its own.
double pixel_scale(const std::string& text, ui::Size size, const ui::Catalogue& tr)
{
    const double scale = positive_number("--scale", text, tr);
    if (scale > largest_scale)
        throw UsageError(
            tr("--scale: found {found}; wanted at most 8 pixels per pixel (displacements are enlarged with --magnify)",
               {{"found", text}}));
    if (std::max(size.width, size.height) * scale > static_cast<double>(largest_side))
        throw UsageError(tr("--size and --scale: the picture would be larger than {most} pixels a side",
                            {{"most", std::to_string(largest_side)}}));
    return scale;
}

} // namespace

std::string kind_of(const std::filesystem::path& path)
{
    std::string kind = path.extension().string();
    std::transform(kind.begin(), kind.end(), kind.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return kind;
}

bool is_picture(const std::filesystem::path& path)
{
    const std::string kind = kind_of(path);
    return kind == ".png" || kind == ".svg" || kind == ".pdf";
}

PictureFile picture_file(const std::string& output, const std::string& size, const std::string& scale,
                         const ui::Catalogue& tr)
{
    PictureFile file{.path = output};
    if (!is_picture(file.path))
        throw UsageError(tr("{file}: cannot draw the kind {kind}; choose from: .png, .svg, .pdf",
                            {{"file", output}, {"kind", "\"" + file.path.extension().string() + "\""}}));
    file.size = size_of(size, tr);
    file.pixel_scale = pixel_scale(scale, file.size, tr);
    return file;
}

ui::ThemeName theme_named(const std::string& name, const ui::Catalogue& tr)
{
    const auto theme = ui::theme_named(name);
    if (!theme) throw unknown_choice("--theme", name, {"light", "dark", "print", "projector"}, tr);
    return *theme;
}

void write_picture(const PictureFile& file, const Backdrop& backdrop, const ui::Drawing& drawing,
                   const ui::Catalogue& tr)
{
    require_writable(file.path, tr);
    const ui::Sheet sheet{
        .size = file.size, .scale = file.pixel_scale, .background = backdrop.color, .title = backdrop.title};
    const std::string kind = kind_of(file.path);
    try {
        if (kind == ".png") ui::paint_to_png(file.path, sheet, drawing);
        if (kind == ".svg") ui::paint_to_svg(file.path, sheet, drawing);
        if (kind == ".pdf") ui::paint_to_pdf(file.path, sheet, drawing);
    } catch (const std::system_error& error) {
        throw UsageError(tr("cannot write {file}: {reason}",
                            {{"file", file.path.string()}, {"reason", tr(error.code().message())}}));
    } catch (const std::exception& error) {
        throw UsageError(tr("cannot draw {file}: {reason}", {{"file", file.path.string()}, {"reason", error.what()}}));
    }
}

} // namespace cli
