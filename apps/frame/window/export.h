#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "apps/frame/session/session.h"
#include "ui/paint/painter.h"

namespace frame {

/// What can be written to a file besides the model; the extension decides:
///
///     .png .svg .pdf   the picture as it is seen           .csv    the results of all cases
///     .html            the calculation report              .txt    model and results in words
///     .report.pdf      the same on paper
///
/// \returns why it cannot be written
std::optional<ui::Message> export_to(const std::filesystem::path& path, const Session& session, const ui::Fonts& fonts,
                                     const ui::Picture& picture, double png_scale);

/// The extensions, that of a name without one first.
std::vector<std::string> export_endings();

} // namespace frame
