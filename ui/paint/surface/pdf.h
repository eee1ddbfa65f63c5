#pragma once

#include "ui/paint/picture.h"
#include "ui/paint/text_measure.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace ui {

struct PdfLook {
    Color background;
    std::string title; ///< shown by readers; may be empty
};

/// A picture somewhere on a page, drawn so many times as large.
struct PlacedPicture {
    Picture picture;
    Point corner; ///< of its top left, on the page
    double scale = 1.0;
};
struct PdfPage {
    Size size; ///< logical pixels
    std::vector<PlacedPicture> pictures{};
};

/// Writes pages as a PDF document (96 logical pixels an inch). Text is embedded as text.
/// \throws std::runtime_error naming the file and what Cairo found when it cannot be written.
void write_pdf(const std::filesystem::path& path, std::span<const PdfPage> pages, const Fonts& fonts,
               const PdfLook& look);

/// Writes the picture as a PDF page of the same size (96 logical pixels an inch). Text is embedded as text.
/// \throws std::runtime_error naming the file and what Cairo found when it cannot be written.
void write_pdf(const std::filesystem::path& path, const Picture& picture, const Fonts& fonts, const PdfLook& look);

} // namespace ui
