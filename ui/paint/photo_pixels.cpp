#include "ui/paint/photo_pixels.h"

#include <png.h>
#include <turbojpeg.h>

#include <array>
#include <cstddef>
#include <memory>

namespace ui {

namespace {

/// What libpng has begun to read.
struct PngImage {
    png_image image{};
    bool is_begun = false;

    explicit PngImage(std::string_view file)
    {
        image.version = PNG_IMAGE_VERSION;
        is_begun = png_image_begin_read_from_memory(&image, file.data(), file.size()) != 0;
    }
    ~PngImage() { png_image_free(&image); }
    PngImage(const PngImage&) = delete;
    PngImage& operator=(const PngImage&) = delete;
};

std::optional<PhotoSize> png_size(std::string_view file)
{
    const PngImage png(file);
    constexpr png_uint_32 most = 0x7FFFFFFF; // as the format has it
    if (!png.is_begun || png.image.width > most || png.image.height > most) return std::nullopt;
    return PhotoSize{static_cast<int>(png.image.width), static_cast<int>(png.image.height)};
}

bool read_png(std::string_view file, std::uint8_t* pixels)
{
    PngImage png(file);
    png.image.format = PNG_FORMAT_RGBA;
    return png.is_begun && png_image_finish_read(&png.image, nullptr, pixels, 0, nullptr) != 0;
}

const unsigned char* bytes_of(std::string_view file) { return reinterpret_cast<const unsigned char*>(file.data()); }

constexpr int careful_jpeg = TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS;

using JpegReader = std::unique_ptr<void, int (*)(tjhandle)>;
JpegReader jpeg_reader() { return {tjInitDecompress(), tjDestroy}; }

std::optional<PhotoSize> jpeg_size(std::string_view file, const JpegReader& reader)
{
    PhotoSize size;
    int subsampling = 0, colors = 0;
    if (!reader || tjDecompressHeader3(reader.get(), bytes_of(file), file.size(), &size.width, &size.height,
                                       &subsampling, &colors) != 0)
        return std::nullopt;
    return size;
}

bool read_jpeg(std::string_view file, std::uint8_t* pixels)
{
    const JpegReader reader = jpeg_reader();
    const auto size = jpeg_size(file, reader);
    return size && tjDecompress2(reader.get(), bytes_of(file), file.size(), pixels, size->width, 0, size->height,
                                 TJPF_RGBA, careful_jpeg) == 0;
}

using JpegBytes = std::unique_ptr<unsigned char, void (*)(unsigned char*)>;

} // namespace

std::optional<PhotoSize> photo_size(std::string_view file, PhotoFormat format)
{
    return format == PhotoFormat::Png ? png_size(file) : jpeg_size(file, jpeg_reader());
}

std::optional<std::string> turned_jpeg(std::string_view file, int orientation)
{
    constexpr std::array by_orientation{TJXOP_NONE,      TJXOP_HFLIP, TJXOP_ROT180,     TJXOP_VFLIP,
                                        TJXOP_TRANSPOSE, TJXOP_ROT90, TJXOP_TRANSVERSE, TJXOP_ROT270};
    const JpegReader turner(tjInitTransform(), tjDestroy);
    tjtransform turn{};
    turn.op = by_orientation.at(static_cast<std::size_t>(orientation - 1));
    turn.options = TJXOPT_TRIM | TJXOPT_COPYNONE;
    unsigned char* bytes = nullptr;
    unsigned long n_bytes = 0;
    const bool is_turned = turner && tjTransform(turner.get(), bytes_of(file), file.size(), 1, &bytes, &n_bytes, &turn,
                                                 careful_jpeg) == 0;
    const JpegBytes turned(bytes, tjFree);
    if (!is_turned) return std::nullopt;
    return std::string(reinterpret_cast<const char*>(bytes), n_bytes);
}

bool read_pixels(std::string_view file, PhotoFormat format, std::uint8_t* pixels)
{
    return format == PhotoFormat::Png ? read_png(file, pixels) : read_jpeg(file, pixels);
}

} // namespace ui
