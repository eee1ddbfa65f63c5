#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "apps/frame/session/session.h"
#include "ui/paint/painter.h"

namespace frame {

/// What the session does not hold.
struct WindowContent {
    const ui::Picture& picture;
    double png_scale = 1.0;
    std::string derivation{}; ///< the steps to the number that is explained, as LaTeX; empty where none is
};

/// What can be written to a file besides the model; the extension decides:
///
///     .png .svg .pdf   the picture as it is seen           .csv    the results of all cases
///     .html            the calculation report              .txt    model and results in words
///     .report.pdf      the same on paper                   .tex    what is worked out by hand, for LaTeX
///
/// \returns why it cannot be written
std::optional<ui::Message> export_to(const std::filesystem::path& path, const Session& session, const ui::Fonts& fonts,
                                     const WindowContent& content);

/// The extensions, that of a name without one first.
std::vector<std::string> export_endings();

} // namespace frame
