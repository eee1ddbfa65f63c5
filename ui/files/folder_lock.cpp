#include "ui/files/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace ui {

FolderLock::FolderLock(const std::filesystem::path& folder)
{
    descriptor_ = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (descriptor_ < 0) return;
    struct stat about = {};
    const bool is_own = fstat(descriptor_, &about) == 0 && about.st_uid == getuid();
    if (is_own && flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
    close(std::exchange(descriptor_, -1));
}

FolderLock::~FolderLock()
{
    if (descriptor_ >= 0) close(descriptor_);
}

} // namespace ui
