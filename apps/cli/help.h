#pragma once

#include <memory>
#include <string>

#include "apps/cli/subcommand.h"
#include "ui/text/catalogue.h"

namespace CLI { // NOLINT(readability-identifier-naming): the name that its authors gave it
class FormatterBase;
}

namespace cli {

/// Lays out `--help`: what the command does, how it is called, every option, examples, what the exit status means.
/// Lines are at most 100 characters wide.
std::shared_ptr<CLI::FormatterBase> help_formatter(const ui::Catalogue& tr);

/// The examples of a subcommand and the meanings of its exit status, the foot of its help.
std::string help_footer(const HelpText& help, const ui::Catalogue& tr);

} // namespace cli
