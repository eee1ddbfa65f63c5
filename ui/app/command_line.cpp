#include "ui/app/command_line.h"

#include <CLI/CLI.hpp>

#include <sstream>

#include "ui/app/app_options.h"

namespace ui {

namespace {

void add(CLI::App& app, const CommandLine::Option& option)
{
    if (option.value.empty()) {
        app.add_flag_callback(
            option.name, [&take = option.take] { take(""); }, option.words);
        return;
    }
    CLI::Option* const added = app.add_option_function<std::string>(option.name, option.take, option.words);
    added->option_text(option.value);
    if (!option.needs.empty()) added->needs(option.needs);
}

} // namespace

void read(const CommandLine& line, int argc, const char* const* argv)
{
    CLI::App app(line.purpose, line.program);
    app.set_version_flag("--version", line.program + " " + line.version);
    app.add_option_function<std::vector<std::string>>("FILE", line.take_files, line.words_of_files)->option_text("...");
    for (const CommandLine::Option& option : line.options) add(app, option);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& end) {
        std::ostringstream text;
        const int status = app.exit(end, text, text);
        if (status == 0) throw OptionsEnd(text.str(), 0);
        throw OptionsEnd::mistake(text.str());
    }
}

} // namespace ui
