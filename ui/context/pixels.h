#pragma once

#include "ui/context/context.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace ui {

/// An opaque picture: red, green, blue and a spare byte (255) a pixel, row by row from the top.
struct Pixels {
    PixelSize size;
    std::vector<std::uint8_t> rgba;

    const std::uint8_t* at(int x, int y) const
    {
        return rgba.data() +
               4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x));
    }
    std::uint8_t* at(int x, int y) { return const_cast<std::uint8_t*>(static_cast<const Pixels&>(*this).at(x, y)); }

    friend bool operator==(const Pixels&, const Pixels&) = default;
};

/// \throws std::runtime_error naming the file and the reason.
void write_png(const std::filesystem::path& path, const Pixels& pixels);
/// Transparent pixels come out over black. \throws std::runtime_error naming the file and the reason.
Pixels read_png(const std::filesystem::path& path);

} // namespace ui
