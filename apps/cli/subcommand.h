#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "apps/cli/console.h"
#include "apps/cli/exit_status.h"
#include "apps/cli/option_parser.h"

namespace cli {

/// A command line to try, and what it does.
struct Example {
    std::string_view command;
    std::string what;
};

/// What `--help` says besides the options. Paragraphs are wrapped when they are printed.
struct HelpText {
    std::string summary;     ///< one line, verb first
    std::string description; ///< paragraphs separated by an empty line
    std::vector<Example> examples;
};

/// One subcommand of `cremona`: it declares its options, then runs with what the user gave them.
/// A new one is a class like this and a line in subcommands.cpp.
class Subcommand {
public:
    virtual ~Subcommand() = default;

    virtual std::string_view name() const = 0;
    virtual HelpText help(const ui::Catalogue& tr) const = 0;
    /// Binds every option to a member; its description is in the user's language.
    virtual void declare(OptionParser& options, const ui::Catalogue& tr) = 0;
    /// \throws UsageError, femoop::ModelError
    virtual ExitStatus run(Console& console) = 0;
};

} // namespace cli
