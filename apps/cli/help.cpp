#include "apps/cli/help.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <sstream>
#include <vector>

#include "femoop/tabular/plain_text.h"

namespace cli {

namespace {

constexpr std::size_t line_width = 100;
constexpr std::size_t option_column = 4; ///< where the text of an option begins, below its name

/// The text in lines of at most `line_width` characters, each after `indent` blanks; line breaks in it are kept.
std::string wrapped(const std::string& text, std::size_t indent)
{
    std::string out;
    std::istringstream paragraphs(text);
    for (std::string paragraph; std::getline(paragraphs, paragraph);) {
        std::istringstream words(paragraph);
        std::string line(indent, ' ');
        for (std::string word; words >> word;) {
            const bool is_first = line.size() == indent;
            if (!is_first && tabular::shown_width(line) + 1 + tabular::shown_width(word) > line_width) {
                out += line + '\n';
                line = std::string(indent, ' ') + word;
            } else {
                line += (is_first ? "" : " ") + word;
            }
        }
        out += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
    }
    return out;
}

class HelpFormatter : public CLI::Formatter {
public:
    explicit HelpFormatter(ui::Catalogue catalogue) : tr_(std::move(catalogue)) {}

    std::string make_help(const CLI::App* app, std::string /*name*/, CLI::AppFormatMode /*mode*/) const override
    {
        const std::string who = app->get_parent() == nullptr ? "" : "cremona " + app->get_name() + ": ";
        std::string text = wrapped(who + app->get_description(), 0) + "\n" + usage(*app);
        text += subcommands(*app) + options(*app, true) + options(*app, false);
        return text + "\n" + app->get_footer();
    }

private:
    std::string usage(const CLI::App& app) const
    {
        const bool is_top = app.get_parent() == nullptr;
        std::string text = tr_("Usage:") + " cremona" + (is_top ? "" : " " + app.get_name());
        for (const CLI::Option* option : app.get_options())
            if (option->get_positional()) text += " " + positional_name(*option);
        return text + (is_top ? " " + tr_("COMMAND [options]") : " " + tr_("[options]")) + "\n";
    }

    static std::string positional_name(const CLI::Option& option)
    {
        return option.get_name(true, false) + (option.get_expected_max() > 1 ? "..." : "");
    }

    std::string subcommands(const CLI::App& app) const
    {
        const auto all = app.get_subcommands([](const CLI::App* sub) { return !sub->get_name().empty(); });
        if (all.empty()) return "";
        std::size_t width = 0;
        for (const CLI::App* sub : all) width = std::max(width, sub->get_name().size());
        std::string text = "\n" + tr_("Commands:") + "\n";
        for (const CLI::App* sub : all) {
            const std::string summary = sub->get_description().substr(0, sub->get_description().find('\n'));
            text += "  " + sub->get_name() + std::string(width - sub->get_name().size() + 2, ' ') + summary + "\n";
        }
        return text;
    }

    std::string options(const CLI::App& app, bool is_positional) const
    {
        std::string text;
        for (const CLI::Option* option : app.get_options())
            if (option->get_positional() == is_positional)
                text += "  " + (is_positional ? positional_name(*option) : option_name(*option)) + "\n" +
                        wrapped(option->get_description(), 2 + option_column);
        if (text.empty()) return text;
        return "\n" + (is_positional ? tr_("Arguments:") : tr_("Options:")) + "\n" + text;
    }

    static std::string option_name(const CLI::Option& option)
    {
        std::string text;
        for (const std::string& name : option.get_snames()) text += (text.empty() ? "-" : ", -") + name;
        for (const std::string& name : option.get_lnames()) text += (text.empty() ? "--" : ", --") + name;
        return option.get_option_text().empty() ? text : text + " " + option.get_option_text();
    }

    ui::Catalogue tr_;
};

} // namespace

std::shared_ptr<CLI::FormatterBase> help_formatter(const ui::Catalogue& tr)
{
    return std::make_shared<HelpFormatter>(tr);
}

std::string help_footer(const HelpText& help, const ui::Catalogue& tr)
{
    std::string text = help.examples.empty() ? std::string() : tr("Examples:") + "\n";
    for (const Example& example : help.examples)
        text += "  " + std::string(example.command) + "\n" + wrapped(example.what, 6);
    text += "\n" + tr("Exit status:") + "\n";
    text += "  0  " + tr("done") + "\n";
    text += "  1  " + tr("the answer is no: a check failed") + "\n";
    text += "  2  " + tr("the input or the arguments are bad; every reason is on stderr, and stdout is empty") + "\n";
    text += "  3  " + tr("the structure cannot be solved: it can move, and stderr says how") + "\n";
    return text;
}

} // namespace cli
