#include "apps/cli/console.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <utility>

#include "ui/text/printable.h"
#include "ui/text/standard_output.h"

namespace cli {

void Console::message(std::string_view line) const
{
    const std::string text = ui::printable(std::string(line) + "\n");
    static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
}

namespace {

const femoop::Fault& last_of(femoop::FaultKind kind, const std::vector<femoop::Fault>& faults)
{
    return *std::find_if(faults.rbegin(), faults.rend(),
                         [&](const femoop::Fault& fault) { return fault.kind == kind; });
}

} // namespace

void Console::report(std::string_view file, const std::vector<femoop::Fault>& faults) const
{
    constexpr std::size_t most_warnings = 50; // of one kind: who reads more? Errors are told one and all.
    std::map<femoop::FaultKind, std::size_t> n_warnings;
    const std::string error = std::string(file) + ": " + tr_("error") + ": ";
    const std::string warning = std::string(file) + ": " + tr_("warning") + ": ";
    for (const femoop::Fault& fault : faults) {
        if (is_error(fault)) message(error + sentence(fault));
        else if (++n_warnings[fault.kind] <= most_warnings) message(warning + sentence(fault));
    }
    for (const auto& [kind, n] : n_warnings)
        if (n > most_warnings)
            message(warning + tr_("and {n} more like \"{sentence}\"", {{"n", std::to_string(n - most_warnings)},
                                                                       {"sentence", sentence(last_of(kind, faults))}}));
}

std::string Console::sentence(const femoop::Fault& fault) const { return femoop::message(fault, tr_); }

void Console::flush()
{
    if (const auto fault = ui::print(std::exchange(results_, {}))) throw UsageError(tr_(*fault));
}

} // namespace cli
