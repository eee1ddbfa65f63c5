#include "femoop/files/whole_file.h"

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <istream>
#include <memory>
#include <string>

#if __has_include(<unistd.h>)
#include <csignal>
#include <sys/stat.h>
#include <unistd.h>
#define FILES_HAS_POSIX 1
#endif

namespace files {

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

#ifdef FILES_HAS_POSIX

Draft draft_beside(const fs::path& target)
{
    std::string name = (target.parent_path() / ("." + target.filename().string() + ".XXXXXX")).string();
    const int descriptor = mkstemp(name.data());
    if (descriptor < 0) return {};
    return {name, File(fdopen(descriptor, "wb"))};
}

/// Waits until the disk has it.
bool to_disk(std::FILE* file) { return std::fflush(file) == 0 && fsync(fileno(file)) == 0; }

/// A file that grows beyond what is allowed then fails to be written, which is told; else it would end the program and
/// leave the draft behind.
class SizeLimitTold {
public:
    SizeLimitTold()
    {
        struct sigaction ignoring = {};
        ignoring.sa_handler = SIG_IGN;
        sigaction(SIGXFSZ, &ignoring, &before_);
    }
    ~SizeLimitTold() { sigaction(SIGXFSZ, &before_, nullptr); }
    SizeLimitTold(const SizeLimitTold&) = delete;
    SizeLimitTold& operator=(const SizeLimitTold&) = delete;

private:
    struct sigaction before_ = {};
};

bool may_write(const fs::path& path) { return access(path.c_str(), W_OK) == 0; }

/// What a new file gets: mkstemp made it for the owner's eyes alone, whose it is whatever the mask, which a browser's
/// file system begins with taking away everything.
fs::perms usual_permissions()
{
    const mode_t mask = umask(0);
    umask(mask);
    return static_cast<fs::perms>(0666U & ~mask) | fs::perms::owner_read | fs::perms::owner_write;
}

#else

Draft draft_beside(const fs::path& target)
{
    fs::path path = target;
    path += ".part";
    return {path, File(std::fopen(path.string().c_str(), "wb"))};
}

bool to_disk(std::FILE* file) { return std::fflush(file) == 0; }

struct SizeLimitTold {};

bool may_write(const fs::path&) { return true; }

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

/// A file that no one may write to is meant to stay as it is, even by whom permissions do not bind.
bool is_protected(const fs::path& path, const fs::file_status& old)
{
    constexpr fs::perms any_write = fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
    return fs::exists(old) && ((old.permissions() & any_write) == fs::perms::none || !may_write(path));
}

/// Where a link leads in the end, whether or not something is there. A circle ends at one of its links.
fs::path end_of_links(fs::path path)
{
    constexpr int most_links = 40;
    std::error_code error;
    for (int i = 0; i < most_links && fs::is_symlink(fs::symlink_status(path, error)); ++i)
        path = path.parent_path() / fs::read_symlink(path, error);
    return path;
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
    if (is_protected(path, old)) return std::make_error_code(std::errc::permission_denied);
    const fs::path target = end_of_links(path);
    if (fs::is_symlink(fs::symlink_status(target, error)))
        return std::make_error_code(std::errc::too_many_symbolic_link_levels);
    [[maybe_unused]] const SizeLimitTold told;
    return replace(target, old, text);
}

namespace {

/// The rest of a stream, as far as one byte beyond what is allowed.
WholeFile rest_of(std::istream& file, std::uintmax_t most_bytes)
{
    WholeFile whole;
    std::array<char, 1 << 16> part{};
    while (file.read(part.data(), part.size()), file.gcount() > 0) {
        whole.text.append(part.data(), static_cast<std::size_t>(file.gcount()));
        if (whole.text.size() > most_bytes) return {{}, std::make_error_code(std::errc::file_too_large)};
    }
    if (file.bad()) return {{}, std::make_error_code(std::errc::io_error)};
    return whole;
}

} // namespace

WholeFile read_whole_file(const fs::path& path, std::uintmax_t most_bytes)
{
    const auto refused = [](std::errc reason) { return WholeFile{{}, std::make_error_code(reason)}; };
    std::error_code unknown;
    const fs::file_status status = fs::status(path, unknown);
    const bool is_piped = path == "/dev/stdin" && fs::is_fifo(status);
    if (fs::is_directory(status)) return refused(std::errc::is_a_directory);
    if (fs::exists(status) && !fs::is_regular_file(status) && !is_piped)
        return refused(std::errc::operation_not_supported);
    if (fs::is_regular_file(status))
        if (const std::uintmax_t size = fs::file_size(path, unknown); !unknown && size > most_bytes)
            return refused(std::errc::file_too_large);
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file) return {{}, last_error()};
    return rest_of(file, most_bytes);
}

} // namespace files
