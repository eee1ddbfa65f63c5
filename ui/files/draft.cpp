#include "ui/files/draft.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <sstream>

#include "femoop/files/whole_file.h"
#include "ui/files/file_lock.h"

namespace ui {

namespace fs = std::filesystem;

namespace {

std::string in_lines(const std::vector<std::string>& texts)
{
    std::string lines;
    for (const std::string& text : texts) lines += text + "\n";
    return lines;
}

std::vector<std::string> lines_of(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::error_code last_error() { return {errno, std::generic_category()}; }

/// Beside 7-0.json: 7-0.json.lock, 7-0.json.path, 7-0.json.about
fs::path beside(fs::path draft, const char* extension) { return draft += extension; }

fs::path lock_of(const fs::path& draft) { return beside(draft, ".lock"); }

bool is_in_use(const fs::path& draft)
{
    const int lock = take_lock(lock_of(draft));
    if (lock >= 0) release_lock(lock_of(draft), lock);
    return lock < 0;
}

/// The draft, what stands beside it, and what was written of it when the program was killed.
void remove_all_of(const fs::path& draft)
{
    const std::string stem = draft.stem().string() + ".";
    std::error_code ignored;
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(draft.parent_path(), ignored)) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with(stem) || name.starts_with("." + stem)) files.push_back(entry.path());
    }
    for (const fs::path& file : files) fs::remove(file, ignored);
}

std::string text_beside(const fs::path& draft, const char* extension)
{
    return files::read_whole_file(beside(draft, extension)).text;
}

std::optional<fs::path> original_of(const fs::path& draft)
{
    const std::string text = text_beside(draft, ".path");
    return text.empty() ? std::nullopt : std::optional<fs::path>(text);
}

/// 7-0.json, but not 7-0.view.json
bool is_draft(const fs::path& path, const std::string& extension)
{
    return path.extension() == extension && path.stem().extension().empty();
}

fs::file_time_type age(const RecoverableFile& recoverable)
{
    std::error_code ignored;
    return fs::last_write_time(recoverable.draft, ignored);
}

} // namespace

std::optional<DraftFolder> draft_folder(std::string_view app, std::string extension)
{
    const auto set = [](const char* name) {
        const char* const value = std::getenv(name);
        return value != nullptr && *value == '/' ? std::optional<fs::path>(value) : std::nullopt;
    };
    std::optional<fs::path> state = set("XDG_STATE_HOME");
    if (const auto home = set("HOME"); home && !state) state = *home / ".local" / "state";
    if (!state) return std::nullopt;
    return DraftFolder{*state / "cremona" / app, std::move(extension)};
}

std::vector<RecoverableFile> recoverable_files(const DraftFolder& folder)
{
    std::vector<RecoverableFile> found;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder.path, error))
        if (is_draft(entry.path(), folder.extension) && !is_in_use(entry.path()))
            found.push_back({entry.path(), original_of(entry.path()), lines_of(text_beside(entry.path(), ".about"))});
    std::ranges::sort(found, std::ranges::greater(), age);
    return found;
}

std::string time_of(const RecoverableFile& recoverable)
{
    std::error_code error;
    const fs::file_time_type time = fs::last_write_time(recoverable.draft, error);
    if (error) return {};
    const auto since = std::chrono::duration_cast<std::chrono::system_clock::duration>(
        fs::file_time_type::clock::now() - time);
    const std::time_t seconds = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now() - since);
    std::tm here{};
    localtime_r(&seconds, &here);
    std::array<char, 32> text{};
    return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M", &here)};
}

std::unique_ptr<Draft> Draft::taken_over(DraftFolder folder, const RecoverableFile& recoverable)
{
    auto draft = std::make_unique<Draft>(std::move(folder));
    draft->lock_ = take_lock(lock_of(recoverable.draft));
    if (draft->lock_ < 0) return nullptr;
    draft->path_ = recoverable.draft;
    std::error_code error;
    if (fs::exists(recoverable.draft, error)) return draft;
    draft->forget();
    return nullptr;
}

Draft::~Draft()
{
    if (lock_ >= 0) release_lock(lock_of(path_), lock_);
}

std::error_code Draft::lock()
{
    std::error_code error;
    fs::create_directories(folder_.path, error);
    if (error) return error;
    // A name that no other document has, in this program or another.
    for (int i = 0; lock_ < 0; ++i) {
        const std::string name = std::to_string(getpid()) + "-" + std::to_string(i) + folder_.extension;
        const fs::path draft = folder_.path / name;
        if (fs::exists(draft, error)) continue;
        lock_ = take_lock(lock_of(draft));
        if (lock_ < 0 && errno != EWOULDBLOCK) return last_error();
        if (lock_ >= 0) path_ = draft;
    }
    return {};
}

std::error_code Draft::keep(const WriteDocument& write, const std::optional<fs::path>& original,
                            const std::vector<std::string>& about)
{
    if (path_.empty())
        if (const std::error_code error = lock()) return error;
    if (const std::error_code error = keep_path(original)) return error;
    if (const std::error_code error = keep_beside(".about", in_lines(about))) return error;
    return write(path_);
}

std::error_code Draft::keep_path(const std::optional<fs::path>& original) const
{
    std::error_code error;
    const fs::path whole = original ? fs::absolute(*original, error) : fs::path();
    return error ? error : keep_beside(".path", whole.string());
}

// What is nothing has no file.
std::error_code Draft::keep_beside(const char* extension, const std::string& text) const
{
    const fs::path file = beside(path_, extension);
    if (!text.empty()) return files::write_whole_file(file, text);
    std::error_code error;
    fs::remove(file, error);
    return error;
}

void Draft::forget()
{
    if (path_.empty()) return;
    remove_all_of(path_);
    release_lock(lock_of(path_), std::exchange(lock_, -1));
    path_.clear();
}

} // namespace ui
