#include "apps/cli/console.h"

#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

namespace cli {

void Console::message(std::string_view line) const
{
    const std::string text = std::string(line) + "\n";
    static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
}

void Console::report(std::string_view file, const std::vector<femoop::Fault>& faults) const
{
    for (const femoop::Fault& fault : faults) {
        const bool is_error = femoop::severity(fault.kind) == femoop::Severity::Error;
        message(std::string(file) + ": " + (is_error ? tr_("error") : tr_("warning")) + ": " + sentence(fault));
    }
}

std::string Console::sentence(const femoop::Fault& fault) const { return femoop::message(fault, tr_); }

void Console::flush()
{
    const std::string results = std::exchange(results_, {});
    errno = 0;
    const bool is_written = std::fwrite(results.data(), 1, results.size(), stdout) == results.size();
    if ((is_written && std::fflush(stdout) == 0) || errno == EPIPE) return;
    const std::string reason = tr_(std::generic_category().message(errno));
    throw UsageError(tr_("cannot write the results to standard output: {reason}", {{"reason", reason}}));
}

} // namespace cli
