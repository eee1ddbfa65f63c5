#include "ui/files/file_lock.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

namespace ui {

int take_lock(const std::filesystem::path& file)
{
    const int descriptor = open(file.c_str(), O_CREAT | O_EXCL | O_RDWR, 0600);
    if (descriptor < 0 && errno == EEXIST) errno = EWOULDBLOCK;
    return descriptor;
}

void release_lock(const std::filesystem::path& file, int descriptor)
{
    close(descriptor);
    unlink(file.c_str());
}

} // namespace ui
