#include "ui/paint/surface/write_file.h"

#include <fstream>
#include <stdexcept>

namespace ui {

void write_file(const std::filesystem::path& path, std::string_view bytes)
{
    std::ofstream out(path, std::ios::binary);
    out << bytes;
    out.flush();
    if (!out)
        throw std::runtime_error("file " + path.string() +
                                 ": cannot be written; check that its folder exists, may be written to and has room");
}

} // namespace ui
