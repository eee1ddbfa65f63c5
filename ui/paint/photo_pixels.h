#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace ui {

// What reads the two formats, by the libraries of a desktop or of a browser's page.

enum class PhotoFormat : std::uint8_t { Png, Jpeg };

struct PhotoSize {
    int width = 0;
    int height = 0;
};

/// Of the head of a file alone, so that nothing takes room yet; nothing where it cannot be read.
std::optional<PhotoSize> photo_size(std::string_view file, PhotoFormat format);
/// Red, green, blue and opacity of each pixel, row by row from the top; false where the file breaks off or is damaged.
/// \pre there is room for those of `photo_size`
bool read_pixels(std::string_view file, PhotoFormat format, std::uint8_t* pixels);
/// A JPEG file whose pixels are stored as `exif_orientation` (ui/paint/exif.h) wants them seen, without a loss but for
/// a strip of less than a block of pixels at an edge. Nothing where it is damaged, or a browser's page has no means for it.
std::optional<std::string> turned_jpeg(std::string_view file, int orientation);

} // namespace ui
