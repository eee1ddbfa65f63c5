#include "ui/context/pixels.h"

#include <cairo.h>

#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>

#include "ui/paint/surface/write_file.h"

namespace ui {

namespace {

using CairoImage = std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)>;

std::runtime_error file_error(const std::filesystem::path& path, const char* failed, cairo_status_t status)
{
    return std::runtime_error("file " + path.string() + ": " + failed + " (" + cairo_status_to_string(status) + ")");
}

// Cairo keeps a pixel as one number of 32 bits, 0xAARRGGBB.
std::uint32_t packed(const std::uint8_t* rgba)
{
    return 0xFF000000u | static_cast<std::uint32_t>(rgba[0]) << 16 | static_cast<std::uint32_t>(rgba[1]) << 8 | rgba[2];
}

void unpack(std::uint32_t argb, std::uint8_t* rgba)
{
    rgba[0] = static_cast<std::uint8_t>(argb >> 16);
    rgba[1] = static_cast<std::uint8_t>(argb >> 8);
    rgba[2] = static_cast<std::uint8_t>(argb);
    rgba[3] = 255;
}

cairo_status_t append(void* text, const unsigned char* bytes, unsigned int n)
{
    static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), n);
    return CAIRO_STATUS_SUCCESS;
}

} // namespace

void write_png(const std::filesystem::path& path, const Pixels& pixels)
{
    const auto [width, height] = pixels.size;
    const CairoImage image(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height), cairo_surface_destroy);
    if (const auto status = cairo_surface_status(image.get()); status != CAIRO_STATUS_SUCCESS)
        throw file_error(path, "the picture cannot be made", status);
    unsigned char* data = cairo_image_surface_get_data(image.get());
    const int stride = cairo_image_surface_get_stride(image.get());
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::uint32_t pixel = packed(pixels.at(x, y));
            std::memcpy(data + static_cast<std::ptrdiff_t>(y) * stride + 4 * x, &pixel, 4);
        }
    }
    cairo_surface_mark_dirty(image.get());
    std::string bytes;
    if (const auto status = cairo_surface_write_to_png_stream(image.get(), append, &bytes);
        status != CAIRO_STATUS_SUCCESS)
        throw file_error(path, "the picture cannot be made", status);
    write_file(path, bytes);
}

Pixels read_png(const std::filesystem::path& path)
{
    const CairoImage image(cairo_image_surface_create_from_png(path.string().c_str()), cairo_surface_destroy);
    if (const auto status = cairo_surface_status(image.get()); status != CAIRO_STATUS_SUCCESS)
        throw file_error(path, "cannot be read as a PNG picture", status);
    Pixels pixels{{cairo_image_surface_get_width(image.get()), cairo_image_surface_get_height(image.get())}, {}};
    pixels.rgba.resize(4 * static_cast<std::size_t>(pixels.size.width) * static_cast<std::size_t>(pixels.size.height));
    const unsigned char* data = cairo_image_surface_get_data(image.get());
    const int stride = cairo_image_surface_get_stride(image.get());
    for (int y = 0; y < pixels.size.height; ++y) {
        for (int x = 0; x < pixels.size.width; ++x) {
            std::uint32_t pixel = 0;
            std::memcpy(&pixel, data + static_cast<std::ptrdiff_t>(y) * stride + 4 * x, 4);
            unpack(pixel, pixels.at(x, y));
        }
    }
    return pixels;
}

} // namespace ui
