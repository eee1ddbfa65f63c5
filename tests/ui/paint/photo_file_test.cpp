#include "ui/paint/exif.h"
#include "ui/paint/photo_file.h"

#include <doctest/doctest.h>
#include <png.h>
#include <turbojpeg.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace {

/// A pixel of each colour, from dark to light.
std::vector<std::uint8_t> shades(int width, int height)
{
    std::vector<std::uint8_t> pixels;
    for (int i = 0; i < width * height; ++i)
        for (const int part : {i % 251, (2 * i) % 251, (3 * i) % 251, 255})
            pixels.push_back(static_cast<std::uint8_t>(part));
    return pixels;
}

std::string png_of(int width, int height, const std::vector<std::uint8_t>& pixels)
{
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(width);
    image.height = static_cast<png_uint_32>(height);
    image.format = PNG_FORMAT_RGBA;
    png_alloc_size_t n_bytes = 0;
    REQUIRE(png_image_write_to_memory(&image, nullptr, &n_bytes, 0, pixels.data(), 0, nullptr) != 0);
    std::string file(n_bytes, '\0');
    REQUIRE(png_image_write_to_memory(&image, file.data(), &n_bytes, 0, pixels.data(), 0, nullptr) != 0);
    file.resize(n_bytes);
    return file;
}

std::string jpeg_of(int width, int height, const std::vector<std::uint8_t>& pixels)
{
    const tjhandle writer = tjInitCompress();
    unsigned char* bytes = nullptr;
    unsigned long n_bytes = 0;
    REQUIRE(tjCompress2(writer, pixels.data(), width, 0, height, TJPF_RGBA, &bytes, &n_bytes, TJSAMP_444, 95, 0) == 0);
    std::string file(reinterpret_cast<const char*>(bytes), n_bytes);
    tjFree(bytes);
    tjDestroy(writer);
    return file;
}

/// The number in so many bytes, the last one first where is_low_first.
std::string bytes_of(unsigned number, int n_bytes, bool is_low_first)
{
    std::string bytes;
    for (int i = 0; i < n_bytes; ++i)
        bytes += static_cast<char>(number >> (8U * static_cast<unsigned>(is_low_first ? i : n_bytes - 1 - i)));
    return bytes;
}

/// A JPEG as a camera writes it, which says how it was held.
std::string held_jpeg(const std::string& jpeg, unsigned orientation, bool is_low_first)
{
    const auto number = [&](unsigned value, int n) { return bytes_of(value, n, is_low_first); };
    const std::string entries = number(0x010F, 2) + number(2, 2) + number(4, 4) + "Cam" + '\0' + //
                                number(0x0112, 2) + number(3, 2) + number(1, 4) + number(orientation, 2) + number(0, 2);
    const std::string tiff = (is_low_first ? "II" : "MM") + number(42, 2) + number(8, 4) + number(2, 2) + entries +
                             number(0, 4);
    const std::string exif = std::string("Exif\0\0", 6) + tiff;
    return jpeg.substr(0, 2) + "\xFF\xE1" + bytes_of(static_cast<unsigned>(exif.size()) + 2, 2, false) + exif +
           jpeg.substr(2);
}

/// Its brightness at a share of its width and height.
int brightness(const ui::Image& image, double x, double y)
{
    const auto column = static_cast<std::size_t>(x * image.width), row = static_cast<std::size_t>(y * image.height);
    return image.pixels[4 * (row * static_cast<std::size_t>(image.width) + column)];
}

} // namespace

TEST_SUITE_BEGIN("photo file");

TEST_CASE("A PNG is read pixel by pixel, and its file is kept as it was")
{
    const auto pixels = shades(7, 5);
    const std::string file = png_of(7, 5, pixels);
    const ui::PhotoReading reading = ui::read_photo(file);
    REQUIRE(reading.photo);
    CHECK_FALSE(reading.fault);
    CHECK(reading.photo->image.width == 7);
    CHECK(reading.photo->image.height == 5);
    CHECK(reading.photo->image.kind == ui::PixelKind::Color);
    CHECK(reading.photo->image.pixels == pixels);
    CHECK(reading.photo->file == file);
    CHECK(reading.photo->media_type == "image/png");
}

TEST_CASE("A JPEG of one colour has that colour everywhere")
{
    std::vector<std::uint8_t> pixels;
    for (int i = 0; i < 24 * 16; ++i) pixels.insert(pixels.end(), {200, 100, 50, 255});
    const ui::PhotoReading reading = ui::read_photo(jpeg_of(24, 16, pixels));
    REQUIRE(reading.photo);
    CHECK(reading.photo->image.width == 24);
    CHECK(reading.photo->image.height == 16);
    CHECK(reading.photo->media_type == "image/jpeg");
    REQUIRE(reading.photo->image.pixels.size() == pixels.size());
    for (std::size_t i = 0; i < pixels.size(); ++i)
        CHECK(std::abs(static_cast<int>(reading.photo->image.pixels[i]) - pixels[i]) <= 3);
}

TEST_CASE("However a camera was held, its photograph stands upright, in its file as well")
{
    // a scene whose four quarters are 20 and 80 above, 140 and 200 below, and what is stored of it [Exif, 4.6.4 A]
    struct Held {
        unsigned orientation;
        std::array<int, 4> stored; // top left, top right, bottom left, bottom right
    };
    const std::array<Held, 8> all{{{1, {20, 80, 140, 200}},
                                   {2, {80, 20, 200, 140}},
                                   {3, {200, 140, 80, 20}},
                                   {4, {140, 200, 20, 80}},
                                   {5, {20, 140, 80, 200}},
                                   {6, {80, 200, 20, 140}},
                                   {7, {200, 80, 140, 20}},
                                   {8, {140, 20, 200, 80}}}};
    for (const Held& held : all)
        for (const bool is_low_first : {false, true}) {
            CAPTURE(held.orientation);
            const bool is_on_its_side = held.orientation > 4;
            const int width = is_on_its_side ? 32 : 48, height = is_on_its_side ? 48 : 32;
            std::vector<std::uint8_t> pixels;
            for (int i = 0; i < width * height; ++i) {
                const std::size_t quarter = (i % width >= width / 2 ? 1U : 0U) + (i / width >= height / 2 ? 2U : 0U);
                const auto shade = static_cast<std::uint8_t>(held.stored.at(quarter));
                pixels.insert(pixels.end(), {shade, shade, shade, 255});
            }
            const std::string file = held_jpeg(jpeg_of(width, height, pixels), held.orientation, is_low_first);
            const auto photo = ui::read_photo(file).photo;
            REQUIRE(photo);
            CHECK(photo->image.width == 48);
            CHECK(photo->image.height == 32);
            CHECK(std::abs(brightness(photo->image, 0.25, 0.25) - 20) <= 3);
            CHECK(std::abs(brightness(photo->image, 0.75, 0.25) - 80) <= 3);
            CHECK(std::abs(brightness(photo->image, 0.25, 0.75) - 140) <= 3);
            CHECK(std::abs(brightness(photo->image, 0.75, 0.75) - 200) <= 3);
            const auto again = ui::read_photo(photo->file).photo; // a page or a drawing has this file in it
            REQUIRE(again);
            CHECK(again->image.pixels == photo->image.pixels);
            CHECK((photo->file == file) == (held.orientation == 1));
        }
}

TEST_CASE("What a camera says in a way that nobody understands turns nothing")
{
    const std::string jpeg = jpeg_of(32, 16, shades(32, 16));
    CHECK(ui::exif_orientation(jpeg) == 1);
    CHECK(ui::exif_orientation(held_jpeg(jpeg, 0, false)) == 1);
    CHECK(ui::exif_orientation(held_jpeg(jpeg, 9, true)) == 1);
    const std::string file = held_jpeg(jpeg, 6, true);
    REQUIRE(ui::exif_orientation(file) == 6);
    const std::size_t number = 42; // where it stands: 12 bytes before the table, 10 of it, one entry, 8 of the next
    for (std::size_t n = 0; n < number + 2; ++n) CHECK(ui::exif_orientation(file.substr(0, n)) == 1);
    CHECK(ui::exif_orientation(file.substr(0, number + 2)) == 6);
}

TEST_CASE("Two readings of one file are not taken for one another")
{
    const std::string file = png_of(2, 2, shades(2, 2));
    CHECK(ui::read_photo(file).photo->image.version != ui::read_photo(file).photo->image.version);
}

TEST_CASE("Neither words nor an empty file nor a GIF is an image that is read")
{
    for (const std::string file : {"", "{}", "GIF89a and so on", "\x89PNG"}) {
        CAPTURE(file);
        const ui::PhotoReading reading = ui::read_photo(file);
        CHECK_FALSE(reading.photo);
        CHECK(reading.fault == ui::PhotoFault::NoImage);
    }
}

TEST_CASE("A file that breaks off anywhere is damaged")
{
    for (const std::string& file : {png_of(40, 30, shades(40, 30)), jpeg_of(40, 30, shades(40, 30))})
        for (std::size_t n = 10; n < file.size() - 12; n += 1 + file.size() / 50) { // a PNG may lack its last 12 bytes
            CAPTURE(n);
            const ui::PhotoReading reading = ui::read_photo(file.substr(0, n));
            CHECK_FALSE(reading.photo);
            CHECK(reading.fault == ui::PhotoFault::Damaged);
        }
}

TEST_CASE("An image that no screen could draw is refused before room is made for it")
{
    const int n = ui::most_pixels_a_side + 1;
    const std::vector<std::uint8_t> row(4 * static_cast<std::size_t>(n), 128);
    for (const std::string& file : {png_of(n, 1, row), jpeg_of(1, n, row)}) {
        const ui::PhotoReading reading = ui::read_photo(file);
        CHECK_FALSE(reading.photo);
        CHECK(reading.fault == ui::PhotoFault::TooLarge);
    }
    std::string bomb = png_of(2, 2, shades(2, 2)); // says that it is two thousand million pixels wide and high
    for (const std::size_t at : {16U, 20U}) bomb.replace(at, 4, std::string("\x7F\xFF\xFF\xFF"));
    CHECK_FALSE(ui::read_photo(bomb).photo);
}

TEST_SUITE_END();
