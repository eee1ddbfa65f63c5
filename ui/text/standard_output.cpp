#include "ui/text/standard_output.h"

#include <cerrno>
#include <cstdio>
#include <utility>

#include "ui/text/printable.h"

namespace ui {

std::error_code print(std::string text)
{
    const std::string shown = printable(std::move(text));
    errno = 0;
    const bool is_taken = std::fwrite(shown.data(), 1, shown.size(), stdout) == shown.size();
    if ((is_taken && std::fflush(stdout) == 0) || errno == EPIPE) return {};
    return {errno, std::generic_category()};
}

} // namespace ui
