#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace ui {

/// What the bytes of a pixel are.
enum class PixelKind : std::uint8_t {
    Coverage, ///< one byte: how much of what is drawn shows
    Color     ///< four: red, green, blue, and opacity, by which the others are not multiplied
};

/// A picture of pixels, which draw lists name as their texture (`ImTextureID`) by address. The renderer uploads it anew
/// whenever `version` is another one.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels; ///< row by row from the top
    std::uint64_t version = 0;
    PixelKind kind = PixelKind::Coverage;
};

/// A picture in colours, and the file that it was read from, which vector formats take in as it is.
struct Photo {
    Image image;
    std::string file;       ///< all of its bytes
    std::string media_type; ///< "image/png", "image/jpeg"
};

} // namespace ui
