#include "tests/golden/webp.h"

#include <stdexcept>

namespace golden {

// Of a build for browsers the texts are compared alone.
void write_webp(const std::filesystem::path& path, const ui::Pixels& /*pixels*/)
{
    throw std::runtime_error(path.string() + ": WebP is not written here");
}

ui::Pixels read_webp(const std::filesystem::path& path)
{
    throw std::runtime_error(path.string() + ": WebP is not read here");
}

} // namespace golden
