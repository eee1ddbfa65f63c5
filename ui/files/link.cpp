#include "ui/files/link.h"

#include <chrono>
#include <cstdlib>
#include <utility>

#include "femoop/files/whole_file.h"

namespace ui {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t most_bytes = 100'000'000;

constexpr const char* file_of(Link::End end) { return end == Link::End::Giver ? "giver" : "taker"; }

constexpr std::string_view prefix = "cremona-link-";

// Of nothing but what the two ends told.
void remove_folder(const fs::path& folder)
{
    std::error_code ignored;
    for (const Link::End end : {Link::End::Giver, Link::End::Taker}) fs::remove(folder / file_of(end), ignored);
    fs::remove(folder, ignored);
}

// Folders of programs that were killed: nobody holds them any more. A young one may be about to be held.
void remove_left_behind(const fs::path& temporary)
{
    constexpr std::chrono::minutes young(1);
    std::error_code error;
    for (fs::directory_iterator entry(temporary, error), end; !error && entry != end; entry.increment(error)) {
        if (!entry->path().filename().string().starts_with(prefix)) continue;
        std::error_code unknown;
        const auto age = fs::file_time_type::clock::now() - fs::last_write_time(entry->path(), unknown);
        if (!unknown && age > young && FolderLock(entry->path()).is_held()) remove_folder(entry->path());
    }
}

} // namespace

std::optional<Link> Link::made()
{
    std::error_code error;
    const fs::path temporary = fs::temp_directory_path(error);
    if (error) return std::nullopt;
    remove_left_behind(temporary);
    std::string name = (temporary / (std::string(prefix) + "XXXXXX")).string();
    if (mkdtemp(name.data()) == nullptr) return std::nullopt;
    Link link(name, End::Giver);
    link.lock_ = FolderLock(name);
    return link;
}

Link::Link(Link&& other) noexcept
    : folder_(std::exchange(other.folder_, {})),
      end_(other.end_),
      lock_(std::move(other.lock_)),
      seen_(other.seen_),
      last_(std::move(other.last_))
{}

Link& Link::operator=(Link&& other) noexcept
{
    if (this == &other) return *this;
    close();
    folder_ = std::exchange(other.folder_, {});
    end_ = other.end_;
    lock_ = std::move(other.lock_);
    seen_ = other.seen_;
    last_ = std::move(other.last_);
    return *this;
}

Link::~Link() { close(); }

void Link::close()
{
    if (folder_.empty()) return;
    std::error_code ignored;
    if (end_ == End::Giver) remove_folder(folder_);
    else fs::remove(folder_ / file_of(end_), ignored);
}

fs::path Link::file_of_other() const { return folder_ / file_of(end_ == End::Giver ? End::Taker : End::Giver); }

std::error_code Link::notify(std::string_view text)
{
    if (is_cut()) return std::make_error_code(std::errc::no_such_file_or_directory);
    return files::write_whole_file(folder_ / file_of(end_), text);
}

std::optional<std::string> Link::heard()
{
    const fs::path path = file_of_other();
    std::error_code error;
    const bool is_file = fs::is_regular_file(fs::symlink_status(path, error));
    const Mark mark{fs::last_write_time(path, error), error ? 0 : fs::file_size(path, error)};
    constexpr std::chrono::seconds young(2); // a file may be replaced within the grain of its time
    const bool is_old = fs::file_time_type::clock::now() - mark.time > young;
    if (error || !is_file || mark.size > most_bytes || (is_old && seen_ == mark)) return std::nullopt;
    files::WholeFile file = files::read_whole_file(path, most_bytes);
    if (file.hindrance) return std::nullopt;
    seen_ = mark;
    if (file.text == last_) return std::nullopt;
    last_ = std::move(file.text);
    return last_;
}

bool Link::is_withdrawn() const
{
    std::error_code error;
    return last_ && fs::symlink_status(file_of_other(), error).type() == fs::file_type::not_found;
}

bool Link::is_cut() const
{
    std::error_code error;
    return folder_.empty() || !fs::is_directory(folder_, error);
}

} // namespace ui
