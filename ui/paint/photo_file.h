#pragma once

#include "ui/paint/image.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace ui {

enum class PhotoFault : std::uint8_t {
    NoImage,  ///< neither PNG nor JPEG
    Damaged,  ///< it breaks off, say
    TooLarge, ///< larger than one of the two bounds
};

/// What an image's file holds, or what hindered reading it.
struct PhotoReading {
    std::shared_ptr<const Photo> photo{};
    std::optional<PhotoFault> fault{}; ///< where there is no photo
};

inline constexpr int most_pixels_a_side = 8192;       ///< that every OpenGL 3.3 of today draws
inline constexpr int most_pixels_in_all = 50'000'000; ///< 200 MB

/// Reads a PNG or a JPEG image from the bytes of its file. What a camera stored on its side, as telephones do, stands
/// upright, and its file is the one that stores it so; in a browser it lies as it is stored.
PhotoReading read_photo(std::string file);

} // namespace ui
