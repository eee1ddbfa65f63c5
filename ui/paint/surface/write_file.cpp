#include "ui/paint/surface/write_file.h"

#include <system_error>

#include "femoop/files/whole_file.h"

namespace ui {

void write_file(const std::filesystem::path& path, std::string_view bytes)
{
    const std::error_code error = files::write_whole_file(path, bytes);
    if (error) throw std::system_error(error, "file " + path.string() + ": cannot be written");
}

} // namespace ui
