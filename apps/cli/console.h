#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "apps/cli/exit_status.h"
#include "femoop/model/fault/fault.h"
#include "ui/text/catalogue.h"

namespace cli {

/// Bad arguments, or a file that cannot be read or written: a sentence in the user's language. Exit status 2.
class UsageError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Where a command speaks: results are kept until the command is done and then go to stdout at once, so that an error
/// leaves stdout empty; messages go to stderr as they come.
class Console {
public:
    explicit Console(ui::Catalogue catalogue) : tr_(std::move(catalogue)) {}

    const ui::Catalogue& tr() const { return tr_; }

    void print(std::string result) { results_.empty() ? results_.swap(result) : void(results_ += result); }
    void message(std::string_view line) const; ///< to stderr, a line of its own
    /// "portal.json: error: ..." for each fault, errors and warnings told apart; of many warnings of one kind the first
    /// ones and how many more there are.
    void report(std::string_view file, const std::vector<femoop::Fault>& faults) const;
    std::string sentence(const femoop::Fault& fault) const; ///< in the user's language

    /// Writes the results to stdout. A reader that has gone away (`| head`) is no error.
    /// \throws UsageError if stdout cannot be written, such as a full disk
    void flush();

private:
    ui::Catalogue tr_;
    std::string results_;
};

} // namespace cli
