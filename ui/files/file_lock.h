#pragma once

#include <filesystem>

namespace ui {

/// A descriptor that holds the lock of that name, which is made, or -1: errno is EWOULDBLOCK if another program holds
/// it. It ends with the program. A browser knows no locks of files: there it is the file that is the lock, and what an
/// earlier page left is removed when a page begins.
int take_lock(const std::filesystem::path& file);
/// \pre the descriptor holds it
void release_lock(const std::filesystem::path& file, int descriptor);

} // namespace ui
