#include "apps/cli/command_line.h"

#include <CLI/CLI.hpp>
#include <exception>
#include <memory>
#include <new>
#include <optional>
#include <string_view>
#include <utility>

#include "apps/cli/console.h"
#include "apps/cli/help.h"
#include "apps/cli/open_app.h"
#include "apps/cli/subcommands.h"
#include "femoop/model/check/suggestion.h"
#include "ui/context/start_program.h"

namespace cli {

namespace {

/// The language must be known before the options are declared, because their help is in it.
std::optional<std::string> language_argument(const std::vector<std::string>& arguments)
{
    std::optional<std::string> language;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        if (arguments[i] == "--lang" && i + 1 < arguments.size()) language = arguments[i + 1];
        if (arguments[i].starts_with("--lang=")) language = arguments[i].substr(7);
    }
    return language;
}

/// A way through the commands for someone who meets them for the first time.
std::vector<Example> first_examples(const ui::Catalogue& tr)
{
    return {
        {"cremona solve examples/portal.json", tr("What happens to a portal frame, as tables.")},
        {"cremona render examples/portal.json -o portal.png --show loads,M,labels",
         tr("The same as a picture, with the bending moments.")},
        {"cremona verify examples/portal.json", tr("Is that what its file expects?")},
        {"cremona solve examples/mechanism.json", tr("A structure that cannot stand: the program says how it moves.")}};
}

/// The command line as CLI11 sees it, and the subcommands bound to it.
class CommandLine {
public:
    CommandLine(Console& console, const std::string& version)
        : console_(console), tr_(console.tr()), subcommands_(all_subcommands())
    {
        app_.name("cremona");
        app_.description(
            tr_("Structural analysis that teaches: solves, explains, draws and verifies frames, "
                "trusses and grillages without a display. Results go to stdout, messages to stderr.") +
            "\n\n" +
            tr_("`cremona COMMAND --help` explains a command. `cremona frame` and `cremona plane` open these "
                "apps, `cremona cross`, `cremona mohr` and `cremona euler` without another word do too, and "
                "`cremona FILE` opens a file in its app."));
        app_.set_version_flag("--version", "cremona " + version, tr_("print the version and leave"));
        app_.footer(help_footer({.summary = {}, .description = {}, .examples = first_examples(tr_)}, tr_));
        prepare(app_);
        app_.require_subcommand(0, 1); // so that a word behind a command is never another one: `cremona bench mesh`
        for (const std::unique_ptr<Subcommand>& subcommand : subcommands_) {
            const HelpText help = subcommand->help(tr_);
            CLI::App* app = app_.add_subcommand(std::string(subcommand->name()),
                                                help.summary + "\n\n" + help.description);
            OptionParser options(*app);
            subcommand->declare(options, tr_);
            app->footer(help_footer(help, tr_));
            prepare(*app);
        }
    }

    ExitStatus run(std::vector<std::string> arguments)
    {
        std::reverse(arguments.begin(), arguments.end()); // CLI11 takes them from the back
        try {
            app_.parse(std::move(arguments));
        } catch (const CLI::CallForHelp&) {
            console_.print(chosen_app().help());
            return ExitStatus::Done;
        } catch (const CLI::CallForVersion&) {
            console_.print(app_.version() + "\n");
            return ExitStatus::Done;
        } catch (const CLI::ParseError& error) {
            throw UsageError(explained(error) + "; " + hint());
        }
        return run_chosen();
    }

private:
    void prepare(CLI::App& app)
    {
        app.formatter(std::dynamic_pointer_cast<CLI::FormatterBase>(help_formatter(tr_)));
        app.set_help_flag("-h,--help", tr_("print this help and leave"));
        app.add_option("--lang", language_, tr_("language of tables, messages and help: en (default) or pt"))
            ->option_text("LANG");
        app.allow_extras(true);
    }

    ExitStatus run_chosen()
    {
        if (const auto extras = app_.remaining(true); !extras.empty()) throw UsageError(unexpected(extras.front()));
        for (const std::unique_ptr<Subcommand>& subcommand : subcommands_)
            if (app_.got_subcommand(std::string(subcommand->name()))) return run_one(*subcommand);
        throw UsageError(tr_("no command is given; see {command}", {{"command", "cremona --help"}}));
    }

    ExitStatus run_one(Subcommand& subcommand)
    {
        const std::string who = "cremona " + std::string(subcommand.name()) + ": ";
        try {
            return subcommand.run(console_);
        } catch (const UsageError& error) {
            throw UsageError(who + error.what());
        } catch (const femoop::ModelError& error) { // of what an option asks of the model
            std::string lines;
            for (const femoop::Fault& fault : error.faults())
                lines += (lines.empty() ? "" : "\n") + who + console_.sentence(fault);
            throw UsageError(lines);
        }
    }

    const CLI::App& chosen_app() const
    {
        const auto chosen = app_.get_subcommands();
        return chosen.empty() ? app_ : *chosen.front();
    }

    std::string hint() const
    {
        const CLI::App& app = chosen_app();
        return tr_(
            "see {command}",
            {{"command", app.get_parent() == nullptr ? "cremona --help" : "cremona " + app.get_name() + " --help"}});
    }

    /// A word that nothing takes: an option or a command that does not exist, or a file too many.
    std::string unexpected(const std::string& word) const
    {
        const CLI::App& app = chosen_app();
        const bool is_option = word.starts_with('-') && word != "-";
        const bool is_command = !is_option && app.get_parent() == nullptr;
        std::vector<std::string> known;
        if (is_command)
            for (const auto& subcommand : subcommands_) known.emplace_back(subcommand->name());
        else if (is_option)
            for (const CLI::Option* option : app.get_options())
                for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
        std::string text = is_command  ? tr_("there is no command {word}", {{"word", word}})
                           : is_option ? tr_("there is no option {word}", {{"word", word}})
                                       : tr_("{word} is one argument too many", {{"word", word}});
        const std::vector<std::string_view> candidates(known.begin(), known.end());
        if (const auto near = femoop::nearest(word.substr(0, word.find('=')), candidates))
            text += "; " + tr_("did you mean {word}?", {{"word", *near}});
        const std::string who = app.get_parent() == nullptr ? "cremona" : "cremona " + app.get_name();
        return who + ": " + text + (text.ends_with('?') ? " " : "; ") + hint();
    }

    /// CLI11's own sentences are English; an option that misses its value is the only one that users meet.
    std::string explained(const CLI::ParseError& error) const
    {
        const std::string text = error.what();
        const std::string option = text.substr(0, text.find(':'));
        const CLI::App& app = chosen_app();
        const std::string who = app.get_parent() == nullptr ? "cremona: " : "cremona " + app.get_name() + ": ";
        if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr)
            return who + tr_("{option} needs a value, and takes one only", {{"option", option}});
        return who + text;
    }

    Console& console_;
    const ui::Catalogue& tr_;
    std::vector<std::unique_ptr<Subcommand>> subcommands_;
    CLI::App app_;
    std::string language_;
};

/// \throws UsageError: the app could not be started
void open_app(const AskedApp& app, const Console& console)
{
    if (const auto reason = ui::become_program(app.program, app.arguments))
        throw UsageError("cremona: " + console.tr()(*reason));
}

ExitStatus run_in_language(const std::vector<std::string>& arguments, const std::string& version, Console& console)
{
    if (const auto app = asked_app(arguments)) open_app(*app, console);
    ExitStatus status = CommandLine(console, version).run(arguments);
    console.flush();
    return status;
}

} // namespace

ExitStatus run(const std::vector<std::string>& arguments, const std::string& version)
{
    const std::optional<std::string> wanted = language_argument(arguments);
    const std::optional<ui::Language> language = ui::language_named(wanted.value_or("en"));
    Console console(language ? ui::Catalogue(*language) : ui::Catalogue());
    try {
        if (!language) throw UsageError("cremona: --lang: there is no language \"" + *wanted + "\"; use en or pt");
        return run_in_language(arguments, version, console);
    } catch (const std::bad_alloc&) {
        console.message(console.tr()("there is not enough memory; close other programs or make the model smaller"));
        return ExitStatus::BadInput;
    } catch (const std::exception& error) {
        console.message(error.what());
        return ExitStatus::BadInput;
    }
}

} // namespace cli
