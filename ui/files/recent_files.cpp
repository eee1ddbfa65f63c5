#include "ui/files/recent_files.h"

#include <fstream>
#include <string>
#include <system_error>
#include <utility>

#include "femoop/files/whole_file.h"

namespace ui {

namespace fs = std::filesystem;

RecentFiles::RecentFiles(fs::path list) : list_(std::move(list)) { read(); }

void RecentFiles::read()
{
    paths_.clear();
    std::ifstream file(list_, std::ios::binary);
    for (std::string line; paths_.size() < most && std::getline(file, line);)
        if (!line.empty()) paths_.emplace_back(line);
}

void RecentFiles::add(const fs::path& path)
{
    std::error_code error;
    const fs::path whole = fs::absolute(path, error).lexically_normal();
    if (error || whole.string().find('\n') != std::string::npos) return;
    read(); // another program may have added to it
    std::erase(paths_, whole);
    paths_.insert(paths_.begin(), whole);
    if (paths_.size() > most) paths_.resize(most);
    std::string text;
    for (const fs::path& kept : paths_) text += kept.string() + '\n';
    fs::create_directories(list_.parent_path(), error);
    (void)files::write_whole_file(list_, text);
}

} // namespace ui
