#include "apps/frame/session/recovery.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>

#include "apps/frame/document/companion/companion_file.h"
#include "femoop/io/model_file.h"
#include "femoop/io/whole_file.h"
#include "femoop/model/fault/fault.h"

namespace frame {

namespace fs = std::filesystem;

namespace {

std::error_code last_error() { return {errno, std::generic_category()}; }

/// Beside beam.json: beam.json.lock, beam.json.path; and beam.view.json, its companion
fs::path beside(fs::path draft, const char* extension) { return draft += extension; }

/// A descriptor that holds the lock of a draft, or -1 if another program holds it.
int take_lock(const fs::path& draft)
{
    const int descriptor = open(beside(draft, ".lock").c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600);
    if (descriptor < 0 || flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
    close(descriptor);
    return -1;
}

bool is_in_use(const fs::path& draft)
{
    const int lock = take_lock(draft);
    if (lock >= 0) close(lock);
    return lock < 0;
}

void remove_all_of(const fs::path& draft)
{
    std::error_code ignored;
    for (const fs::path& path : {draft, companion_path(draft), beside(draft, ".path"), beside(draft, ".lock")})
        fs::remove(path, ignored);
}

std::optional<fs::path> original_of(const fs::path& draft)
{
    std::ifstream file(beside(draft, ".path"), std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    return text.empty() ? std::nullopt : std::optional<fs::path>(text);
}

bool is_draft(const fs::path& path) { return path.extension() == ".json" && !model_of_companion(path); }

fs::file_time_type age(const Leftover& leftover)
{
    std::error_code ignored;
    return fs::last_write_time(leftover.draft, ignored);
}

} // namespace

std::optional<fs::path> state_folder()
{
    const auto set = [](const char* name) {
        const char* const value = std::getenv(name);
        return value != nullptr && *value == '/' ? std::optional<fs::path>(value) : std::nullopt;
    };
    if (const auto state = set("XDG_STATE_HOME")) return *state / "cremona" / "frame";
    if (const auto home = set("HOME")) return *home / ".local" / "state" / "cremona" / "frame";
    return std::nullopt;
}

Recovery::~Recovery()
{
    if (lock_ >= 0) close(lock_);
}

std::error_code Recovery::lock()
{
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error) return error;
    // A name that no other document has, in this program or another.
    for (int i = 0; lock_ < 0; ++i) {
        const fs::path draft = folder_ / (std::to_string(getpid()) + "-" + std::to_string(i) + ".json");
        if (fs::exists(draft, error)) continue;
        errno = 0;
        lock_ = take_lock(draft);
        if (lock_ < 0 && errno != EWOULDBLOCK) return last_error();
        if (lock_ >= 0) draft_ = draft;
    }
    return {};
}

std::error_code Recovery::keep(const Document& document, const std::optional<fs::path>& original)
{
    if (draft_.empty())
        if (const std::error_code error = lock()) return error;
    if (original) {
        const std::error_code error = femoop::write_whole_file(beside(draft_, ".path"),
                                                               fs::absolute(*original).string());
        if (error) return error;
    }
    if (const std::error_code error = save_companion_of(draft_, document)) return error;
    return femoop::write_whole_file(draft_, femoop::write_model(document.model));
}

void Recovery::forget()
{
    if (draft_.empty()) return;
    remove_all_of(draft_);
    close(std::exchange(lock_, -1));
    draft_.clear();
}

std::vector<Leftover> Recovery::leftovers() const
{
    std::vector<Leftover> found;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error))
        if (is_draft(entry.path()) && !is_in_use(entry.path()))
            found.push_back({entry.path(), original_of(entry.path())});
    std::ranges::sort(found, std::ranges::greater(), age);
    return found;
}

void Recovery::discard(const Leftover& leftover) { remove_all_of(leftover.draft); }

} // namespace frame
