#pragma once

#include "ui/context/pixels.h"

#include <filesystem>

namespace golden {

/// Reference pictures are kept as lossless WebP: two fifths of what PNG takes.
/// \throws std::runtime_error naming the file and the reason.
void write_webp(const std::filesystem::path& path, const ui::Pixels& pixels);
ui::Pixels read_webp(const std::filesystem::path& path);

} // namespace golden
