#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "apps/cli/console.h"
#include "apps/cli/exit_status.h"
#include "apps/frame/document/companion/named_view.h"
#include "apps/frame/view/view_options.h"
#include "femoop/model/model.h"
#include "ui/paint/geometry.h"

namespace cli {

/// A picture to be written; its kind is the file's extension: .png, .svg or .pdf.
struct PictureOrder {
    std::filesystem::path path;
    ui::Size size{1280.0, 800.0};         ///< logical pixels
    double pixel_scale = 1.0;             ///< pixels per logical pixel, PNG alone
    std::optional<std::size_t> mechanism; ///< which way of moving is drawn when the structure cannot be solved
    frame::ViewOptions view;
    std::optional<frame::Region> region; ///< of a plane model that is looked at; the whole when absent
};

/// The extension in small letters: A.PNG is a .png too.
std::string kind_of(const std::filesystem::path& path);

/// True for an extension that a picture can have.
bool is_picture(const std::filesystem::path& path);

/// Solves the model and draws it with its results. A structure that can move is drawn moving: the motions are told on
/// stderr and the status is CannotSolve. \throws UsageError if the file cannot be written
ExitStatus draw_picture(const femoop::Model& model, const std::string& file, const PictureOrder& order,
                        const Console& console);

/// How pictures are drawn when no option says otherwise: in the language of `tr`, with its decimal mark.
frame::ViewOptions view_options(const ui::Catalogue& tr);

} // namespace cli
