#pragma once

#include "ui/paint/picture.h"
#include "ui/paint/text_measure.h"

#include <filesystem>
#include <string>

namespace ui {

struct PdfLook {
    Color background;
    std::string title; ///< shown by readers; may be empty
};

/// Writes the picture as a PDF page of the same size (96 logical pixels an inch). Text is embedded as text.
/// \throws std::runtime_error naming the file and what Cairo found when it cannot be written.
void write_pdf(const std::filesystem::path& path, const Picture& picture, const Fonts& fonts, const PdfLook& look);

} // namespace ui
