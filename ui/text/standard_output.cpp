#include "ui/text/standard_output.h"

#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

#include "ui/text/catalogue.h"
#include "ui/text/printable.h"

namespace ui {

std::optional<Message> print(std::string text)
{
    const std::string shown = printable(std::move(text));
    errno = 0;
    const bool is_taken = std::fwrite(shown.data(), 1, shown.size(), stdout) == shown.size();
    if ((is_taken && std::fflush(stdout) == 0) || errno == EPIPE) return std::nullopt;
    const Message reason(std::generic_category().message(errno));
    return Message{translatable("cannot write to standard output: {reason}"), {{"reason", reason}}};
}

} // namespace ui
