#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ui {

/// A picture of coverage alone, one byte a pixel, that draw lists name as their texture (`ImTextureID`) by address.
/// The renderer uploads it anew whenever `version` has grown.
struct AlphaImage {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels; ///< row by row from the top
    std::uint64_t version = 0;
};

} // namespace ui
