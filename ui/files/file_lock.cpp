#include "ui/files/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

namespace ui {

int take_lock(const std::filesystem::path& file)
{
    const int descriptor = open(file.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600);
    if (descriptor < 0 || flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
    close(descriptor);
    errno = EWOULDBLOCK;
    return -1;
}

void release_lock(const std::filesystem::path&, int descriptor) { close(descriptor); }

} // namespace ui
