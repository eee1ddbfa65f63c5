#pragma once

#include <filesystem>
#include <string>

#include "apps/cli/console.h"
#include "ui/paint/color.h"
#include "ui/paint/geometry.h"
#include "ui/paint/paint_to_file.h"
#include "ui/paint/theme.h"

namespace cli {

/// A picture to be written; its kind is the file's extension: .png, .svg or .pdf.
struct PictureFile {
    std::filesystem::path path;
    ui::Size size{1280.0, 800.0}; ///< logical pixels
    double pixel_scale = 1.0;     ///< pixels per logical pixel, PNG alone
};

/// The extension in small letters: A.PNG is a .png too.
std::string kind_of(const std::filesystem::path& path);

/// True for an extension that a picture can have.
bool is_picture(const std::filesystem::path& path);

/// The picture as the values of -o, --size and --scale want it. \throws UsageError
PictureFile picture_file(const std::string& output, const std::string& size, const std::string& scale,
                         const ui::Catalogue& tr);

/// The value of --theme. \throws UsageError
ui::ThemeName theme_named(const std::string& name, const ui::Catalogue& tr);

/// What surrounds a drawing in its file.
struct Backdrop {
    ui::Color color;
    std::string title;
};

/// \throws UsageError if the file cannot be written
void write_picture(const PictureFile& file, const Backdrop& backdrop, const ui::Drawing& drawing,
                   const ui::Catalogue& tr);

} // namespace cli
