#include "ui/paint/photo_file.h"

#include "ui/paint/exif.h"
#include "ui/paint/photo_pixels.h"

#include <atomic>
#include <cstddef>
#include <string_view>
#include <utility>

namespace ui {

namespace {

bool is_too_large(const PhotoSize& size)
{
    const std::int64_t width = size.width, height = size.height;
    return width > most_pixels_a_side || height > most_pixels_a_side || width * height > most_pixels_in_all;
}

/// Room for the pixels in colours; by its version none is taken for another one at its address.
Image empty_image(const PhotoSize& size)
{
    static std::atomic<std::uint64_t> n_read = std::uint64_t{1} << 32U; // above those of pages of letters
    return {.width = size.width,
            .height = size.height,
            .pixels = std::vector<std::uint8_t>(4 * static_cast<std::size_t>(size.width) *
                                                static_cast<std::size_t>(size.height)),
            .version = ++n_read,
            .kind = PixelKind::Color};
}

} // namespace

PhotoReading read_photo(std::string file)
{
    using namespace std::string_view_literals;
    const bool is_png = file.starts_with("\x89PNG\r\n\x1a\n"sv), is_jpeg = file.starts_with("\xff\xd8\xff"sv);
    if (!is_png && !is_jpeg) return {.fault = PhotoFault::NoImage};
    const PhotoFormat format = is_png ? PhotoFormat::Png : PhotoFormat::Jpeg;
    const auto size = photo_size(file, format);
    if (!size || size->width < 1 || size->height < 1) return {.fault = PhotoFault::Damaged};
    if (is_too_large(*size)) return {.fault = PhotoFault::TooLarge};
    if (const int orientation = is_jpeg ? exif_orientation(file) : 1; orientation != 1)
        if (auto turned = turned_jpeg(file, orientation)) return read_photo(std::move(*turned));
    Image image = empty_image(*size);
    if (!read_pixels(file, format, image.pixels.data())) return {.fault = PhotoFault::Damaged};
    return {.photo = std::make_shared<const Photo>(
                Photo{std::move(image), std::move(file), is_png ? "image/png" : "image/jpeg"})};
}

} // namespace ui
