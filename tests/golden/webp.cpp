#include "tests/golden/webp.h"

#include "tests/text_of.h"

#include <webp/decode.h>
#include <webp/encode.h>

#include <cstdint>
#include <fstream>
#include <memory>
#include <stdexcept>

namespace golden {

namespace {

struct FreedByWebP {
    void operator()(std::uint8_t* bytes) const { WebPFree(bytes); }
};

using WebPBytes = std::unique_ptr<std::uint8_t, FreedByWebP>;

} // namespace

void write_webp(const std::filesystem::path& path, const ui::Pixels& pixels)
{
    const int width = pixels.size.width, height = pixels.size.height;
    std::uint8_t* bytes = nullptr;
    const std::size_t n = WebPEncodeLosslessRGBA(pixels.rgba.data(), width, height, 4 * width, &bytes);
    const WebPBytes owner(bytes);
    std::ofstream out(path, std::ios::binary);
    out.write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(n));
    if (n == 0 || !out.flush()) throw std::runtime_error(path.string() + " cannot be written as a WebP picture");
}

ui::Pixels read_webp(const std::filesystem::path& path)
{
    const std::string file = ::text_of(path);
    ui::Pixels pixels;
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(file.data());
    const WebPBytes rgba(WebPDecodeRGBA(bytes, file.size(), &pixels.size.width, &pixels.size.height));
    if (!rgba) throw std::runtime_error(path.string() + " cannot be read as a WebP picture");
    const auto n = 4 * static_cast<std::size_t>(pixels.size.width) * static_cast<std::size_t>(pixels.size.height);
    pixels.rgba.assign(rgba.get(), rgba.get() + n);
    return pixels;
}

} // namespace golden
