#include "ui/paint/exif.h"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace ui {

namespace {

using namespace std::string_view_literals;

enum class ByteOrder : std::uint8_t { LowFirst, HighFirst };

/// Bytes of which any may lack: what is read beyond their end is nothing.
class Bytes {
public:
    Bytes(std::string_view bytes, ByteOrder order) : bytes_(bytes), order_(order) {}

    std::optional<std::size_t> number(std::size_t at, std::size_t n_bytes) const
    {
        if (at > bytes_.size() || n_bytes > bytes_.size() - at) return std::nullopt;
        std::size_t value = 0;
        for (std::size_t i = 0; i < n_bytes; ++i) {
            const std::size_t place = order_ == ByteOrder::HighFirst ? i : n_bytes - 1 - i;
            value = 256 * value + static_cast<unsigned char>(bytes_[at + place]);
        }
        return value;
    }

private:
    std::string_view bytes_;
    ByteOrder order_;
};

/// The segment of Exif, without its name; empty where there is none before the pixels begin.
std::string_view exif_of(std::string_view jpeg)
{
    constexpr std::size_t exif_marker = 0xFFE1, start_of_scan = 0xFFDA;
    constexpr std::string_view name = "Exif\0\0"sv;
    const Bytes bytes(jpeg, ByteOrder::HighFirst);
    for (std::size_t at = 2; at < jpeg.size();) {                                  // behind the start of the image
        const auto marker = bytes.number(at, 2), length = bytes.number(at + 2, 2); // which counts its own two bytes
        if (!marker || !length || *marker < 0xFF00 || *marker == start_of_scan || *length < 2) return {};
        const std::string_view segment = jpeg.substr(at + 4).substr(0, *length - 2);
        if (*marker == exif_marker && segment.starts_with(name)) return segment.substr(name.size());
        at += 2 + *length;
    }
    return {};
}

} // namespace

int exif_orientation(std::string_view jpeg)
{
    constexpr std::size_t orientation_tag = 0x0112, short_number = 3, entry_size = 12;
    const std::string_view exif = exif_of(jpeg); // laid out as a TIFF file
    const bool is_low_first = exif.starts_with("II*\0"sv);
    if (!is_low_first && !exif.starts_with("MM\0*"sv)) return 1;
    const Bytes bytes(exif, is_low_first ? ByteOrder::LowFirst : ByteOrder::HighFirst);
    const auto directory = bytes.number(4, 4);
    const auto n_entries = directory ? bytes.number(*directory, 2) : std::nullopt;
    for (std::size_t i = 0; i < n_entries.value_or(0); ++i) {
        const std::size_t entry = *directory + 2 + i * entry_size;
        if (bytes.number(entry, 2) != orientation_tag || bytes.number(entry + 2, 2) != short_number) continue;
        const std::size_t orientation = bytes.number(entry + 8, 2).value_or(1);
        return orientation >= 1 && orientation <= 8 ? static_cast<int>(orientation) : 1;
    }
    return 1;
}

} // namespace ui
