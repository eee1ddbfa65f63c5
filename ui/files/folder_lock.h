#pragma once

#include <filesystem>
#include <utility>

namespace ui {

/// Says that a folder is in use, as long as it lives and its program does: the system takes the lock from a program
/// that is killed.
class FolderLock {
public:
    FolderLock() = default; ///< of no folder
    /// Of a folder of this user's, no link to one. Holds nothing where another holds it or the folder cannot be opened.
    explicit FolderLock(const std::filesystem::path& folder);
    FolderLock(FolderLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
    FolderLock& operator=(FolderLock&& other) noexcept
    {
        std::swap(descriptor_, other.descriptor_);
        return *this;
    }
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;
    ~FolderLock();

    bool is_held() const { return descriptor_ >= 0; }

private:
    int descriptor_ = -1;
};

} // namespace ui
