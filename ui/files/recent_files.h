#pragma once

#include <filesystem>
#include <vector>

namespace ui {

/// The files that were opened or saved last, kept in a file of one path a line.
class RecentFiles {
public:
    static constexpr std::size_t most = 10;

    /// The list as it was kept; empty where there is none.
    explicit RecentFiles(std::filesystem::path list);

    const std::vector<std::filesystem::path>& paths() const { return paths_; } ///< the last used first
    /// Puts the file first, before those that other programs have added meanwhile, and keeps the list; a list that
    /// cannot be written is no reason to stop.
    void add(const std::filesystem::path& path);

private:
    void read();

    std::filesystem::path list_;
    std::vector<std::filesystem::path> paths_;
};

} // namespace ui
