// Whatever the bytes, an image is read within its bounds or refused; and one that was read is read again from the file
// that is kept of it.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "ui/paint/exif.h"
#include "ui/paint/photo_file.h"
#include "ui/paint/photo_pixels.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    constexpr std::int64_t most_pixels = 1'000'000; // larger ones only take time
    const std::string file(reinterpret_cast<const char*>(data), size);
    const int orientation = ui::exif_orientation(file);
    if (orientation < 1 || orientation > 8) std::abort();
    const auto format = file.starts_with("\x89PNG") ? ui::PhotoFormat::Png : ui::PhotoFormat::Jpeg;
    const ui::PhotoSize announced = ui::photo_size(file, format).value_or(ui::PhotoSize{});
    if (std::int64_t{announced.width} * announced.height > most_pixels) return 0;
    const ui::PhotoReading reading = ui::read_photo(file);
    if ((reading.photo == nullptr) != reading.fault.has_value()) std::abort();
    if (!reading.photo) return 0;
    const ui::Image& image = reading.photo->image;
    if (image.width < 1 || image.height < 1) std::abort();
    if (image.pixels.size() != 4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height))
        std::abort();
    const ui::PhotoReading again = ui::read_photo(reading.photo->file);
    if (!again.photo || again.photo->image.pixels != image.pixels) std::abort();
    return 0;
}
