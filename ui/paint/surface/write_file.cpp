#include "ui/paint/surface/write_file.h"

#include <fstream>
#include <stdexcept>
#include <system_error>

#if __has_include(<unistd.h>)
#include <csignal>
#define UI_HAS_SIZE_LIMITS 1
#endif

namespace ui {

namespace {

#ifdef UI_HAS_SIZE_LIMITS

/// A file that grows beyond what is allowed then fails to be written, which is told; else it would end the program.
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

#else

struct SizeLimitTold {};

#endif

namespace fs = std::filesystem;

bool is_written(const fs::path& path, std::string_view bytes)
{
    std::ofstream out(path, std::ios::binary);
    out << bytes;
    out.close();
    return out.good();
}

bool is_made(const fs::path& path, std::string_view bytes)
{
    if (is_written(path, bytes)) return true;
    std::error_code ignored;
    fs::remove(path, ignored); // a part of a picture is none
    return false;
}

/// Writes beside the old file, which then gives its permissions and its name: it is lost only once the new one is whole.
bool is_replaced(const fs::path& path, std::string_view bytes)
{
    std::error_code error;
    const fs::path target = fs::canonical(path, error); // what a link leads to
    const fs::path draft = target.parent_path() / ("." + target.filename().string() + ".part");
    if (error || !std::ofstream(target, std::ios::app) || !is_made(draft, bytes)) return false;
    fs::permissions(draft, fs::status(target, error).permissions(), error);
    if (!error) fs::rename(draft, target, error);
    std::error_code ignored;
    if (error) fs::remove(draft, ignored);
    return !error;
}

bool is_stored(const fs::path& path, std::string_view bytes)
{
    std::error_code ignored;
    const fs::file_status old = fs::status(path, ignored);
    if (fs::is_regular_file(old)) return is_replaced(path, bytes);
    return fs::exists(old) ? is_written(path, bytes) : is_made(path, bytes); // a pipe takes it as it comes
}

} // namespace

void write_file(const fs::path& path, std::string_view bytes)
{
    [[maybe_unused]] const SizeLimitTold told;
    if (is_stored(path, bytes)) return;
    throw std::runtime_error("file " + path.string() +
                             ": cannot be written; check that its folder exists, may be written to and has room");
}

} // namespace ui
