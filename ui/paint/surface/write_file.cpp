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

bool is_written(const std::filesystem::path& path, std::string_view bytes)
{
    std::ofstream out(path, std::ios::binary);
    out << bytes;
    out.close();
    return out.good();
}

} // namespace

void write_file(const std::filesystem::path& path, std::string_view bytes)
{
    [[maybe_unused]] const SizeLimitTold told;
    std::error_code ignored;
    const bool is_new = !std::filesystem::exists(path, ignored);
    if (is_written(path, bytes)) return;
    if (is_new) std::filesystem::remove(path, ignored); // a part of a picture is none
    throw std::runtime_error("file " + path.string() +
                             ": cannot be written; check that its folder exists, may be written to and has room");
}

} // namespace ui
