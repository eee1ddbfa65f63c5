#include "ui/context/pixels.h"

#include <stdexcept>
#include <string>

#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#include <stb/stb_image.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

#include "ui/paint/surface/write_file.h"

namespace ui {

void write_png(const std::filesystem::path& path, const Pixels& pixels)
{
    const auto append = [](void* text, void* bytes, int n) {
        static_cast<std::string*>(text)->append(static_cast<const char*>(bytes), static_cast<std::size_t>(n));
    };
    constexpr int n_channels = 4;
    const auto [width, height] = pixels.size;
    std::string bytes;
    if (!stbi_write_png_to_func(append, &bytes, width, height, n_channels, pixels.rgba.data(), n_channels * width))
        throw std::runtime_error("file " + path.string() + ": the picture cannot be made");
    write_file(path, bytes);
}

Pixels read_png(const std::filesystem::path& path)
{
    constexpr int n_channels = 4;
    Pixels pixels;
    int n_in_file = 0;
    unsigned char* const read = stbi_load(path.c_str(), &pixels.size.width, &pixels.size.height, &n_in_file,
                                          n_channels);
    if (!read) throw std::runtime_error("file " + path.string() + ": cannot be read as a PNG picture");
    pixels.rgba.assign(read, read + static_cast<std::ptrdiff_t>(n_channels) * pixels.size.width * pixels.size.height);
    stbi_image_free(read);
    return pixels;
}

} // namespace ui
