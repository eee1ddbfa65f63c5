#include "femoop/io/whole_file.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

#if __has_include(<unistd.h>)
#include <sys/stat.h>
#include <unistd.h>
#define FEMOOP_HAS_POSIX_FILES 1
#endif

namespace femoop {

namespace fs = std::filesystem;

namespace {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

std::error_code last_error() { return {errno != 0 ? errno : EIO, std::generic_category()}; }

/// A new file in the same folder, open for writing.
struct Draft {
    fs::path path;
    File file;
};

#ifdef FEMOOP_HAS_POSIX_FILES

Draft draft_beside(const fs::path& target)
{
    std::string name = (target.parent_path() / ("." + target.filename().string() + ".XXXXXX")).string();
    const int descriptor = mkstemp(name.data());
    if (descriptor < 0) return {};
    return {name, File(fdopen(descriptor, "wb"))};
}

/// Waits until the disk has it.
bool to_disk(std::FILE* file) { return std::fflush(file) == 0 && fsync(fileno(file)) == 0; }

/// What a new file gets: mkstemp made it for the owner's eyes alone.
fs::perms usual_permissions()
{
    const mode_t mask = umask(0);
    umask(mask);
    return static_cast<fs::perms>(0666U & ~mask);
}

#else

Draft draft_beside(const fs::path& target)
{
    fs::path path = target;
    path += ".part";
    return {path, File(std::fopen(path.string().c_str(), "wb"))};
}

bool to_disk(std::FILE* file) { return std::fflush(file) == 0; }

fs::perms usual_permissions() { return fs::perms::owner_read | fs::perms::owner_write; }

#endif

std::error_code write_text(std::FILE* file, std::string_view text)
{
    const bool is_written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
    return is_written ? std::error_code() : last_error();
}

std::error_code write_directly(const fs::path& path, std::string_view text)
{
    const File file(std::fopen(path.string().c_str(), "wb"));
    if (!file) return last_error();
    if (const std::error_code error = write_text(file.get(), text)) return error;
    return std::fflush(file.get()) == 0 ? std::error_code() : last_error();
}

std::error_code replace(const fs::path& target, const fs::file_status& old, std::string_view text)
{
    Draft draft = draft_beside(target);
    if (!draft.file) return last_error();
    std::error_code error = write_text(draft.file.get(), text);
    if (!error && !to_disk(draft.file.get())) error = last_error();
    draft.file.reset();
    if (!error) fs::permissions(draft.path, fs::exists(old) ? old.permissions() : usual_permissions(), error);
    if (!error) fs::rename(draft.path, target, error);
    std::error_code ignored;
    if (error) fs::remove(draft.path, ignored);
    return error;
}

} // namespace

std::error_code write_whole_file(const fs::path& path, std::string_view text)
{
    errno = 0;
    std::error_code error;
    const fs::file_status old = fs::status(path, error);
    if (fs::is_directory(old)) return std::make_error_code(std::errc::is_a_directory);
    if (fs::exists(old) && !fs::is_regular_file(old)) return write_directly(path, text);
    const fs::path target = fs::is_symlink(path, error) ? fs::weakly_canonical(path, error) : path;
    return replace(target, old, text);
}

} // namespace femoop
