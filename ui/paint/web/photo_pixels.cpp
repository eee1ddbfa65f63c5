#include "ui/paint/photo_pixels.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_JPEG
#define STBI_ONLY_PNG
#include <stb/stb_image.h>

#include <algorithm>
#include <cstddef>
#include <memory>

namespace ui {

namespace {

constexpr int n_channels = 4;

const stbi_uc* bytes_of(std::string_view file) { return reinterpret_cast<const stbi_uc*>(file.data()); }
int length_of(std::string_view file) { return static_cast<int>(file.size()); }

} // namespace

std::optional<PhotoSize> photo_size(std::string_view file, PhotoFormat)
{
    PhotoSize size;
    int n_in_file = 0;
    if (stbi_info_from_memory(bytes_of(file), length_of(file), &size.width, &size.height, &n_in_file) == 0)
        return std::nullopt;
    return size;
}

std::optional<std::string> turned_jpeg(std::string_view, int) { return std::nullopt; }

bool read_pixels(std::string_view file, PhotoFormat, std::uint8_t* pixels)
{
    PhotoSize size;
    int n_in_file = 0;
    const std::unique_ptr<stbi_uc, void (*)(void*)> read(
        stbi_load_from_memory(bytes_of(file), length_of(file), &size.width, &size.height, &n_in_file, n_channels),
        stbi_image_free);
    if (!read) return false;
    std::copy_n(read.get(),
                static_cast<std::size_t>(n_channels) * static_cast<std::size_t>(size.width) *
                    static_cast<std::size_t>(size.height),
                pixels);
    return true;
}

} // namespace ui
