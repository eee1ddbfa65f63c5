#include "ui/paint/surface/write_file.h"

#include "femoop/files/whole_file.h"

namespace ui {

void write_file(const std::filesystem::path& path, std::string_view bytes)
{
    if (!files::write_whole_file(path, bytes)) return;
    throw NotWritten("file " + path.string() +
                     ": cannot be written; check that its folder exists, may be written to and has room");
}

} // namespace ui
