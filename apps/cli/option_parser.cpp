#include "apps/cli/option_parser.h"

#include <CLI/CLI.hpp>

namespace cli {

DeclaredOption& DeclaredOption::option_text(const std::string& text)
{
    option_->option_text(text);
    return *this;
}

DeclaredOption& DeclaredOption::one_value_each()
{
    option_->allow_extra_args(false);
    return *this;
}

DeclaredOption& DeclaredOption::last_value()
{
    option_->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    return *this;
}

DeclaredOption& DeclaredOption::add_description(const std::string& text)
{
    option_->description(option_->get_description() + "; " + text);
    return *this;
}

std::vector<std::string> DeclaredOption::results() const { return option_->results(); }

DeclaredOption OptionParser::add_option(const std::string& name, std::string& value, const std::string& description)
{
    return DeclaredOption(app_.add_option(name, value, description));
}

DeclaredOption OptionParser::add_option(const std::string& name, std::optional<std::string>& value,
                                        const std::string& description)
{
    return DeclaredOption(app_.add_option(name, value, description));
}

DeclaredOption OptionParser::add_option(const std::string& name, std::vector<std::string>& values,
                                        const std::string& description)
{
    return DeclaredOption(app_.add_option(name, values, description));
}

void OptionParser::add_flag(const std::string& name, bool& value, const std::string& description)
{
    app_.add_flag(name, value, description);
}

DeclaredOption OptionParser::option(const std::string& name) { return DeclaredOption(app_.get_option(name)); }

} // namespace cli
