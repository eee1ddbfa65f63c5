#include "apps/frame/window/options.h"

#include <CLI/CLI.hpp>

namespace frame {

namespace {

const ui::OptionWords words{
    .files = "model files (.json) to open, each in a tab; - opens what is redirected here, as a copy without a file",
    .describe = "print the model and its results in words and leave; needs no display",
};

} // namespace

Options parse_options(int argc, const char* const* argv, const std::string& version)
{
    Options options;
    std::string units, show, load_case;
    CLI::App app("Shows a frame, truss or grillage at work: loads, supports, N, V, M, deformed shape; "
                 "every number can be changed and the results follow.",
                 "frame");
    app.set_version_flag("--version", "frame " + version);
    ui::add_app_options(app, options, words);
    app.add_option(
           "--units", units,
           "units shown: file, si, kn-m, kn-cm or us; default as it was left, at first those that go with the file")
        ->option_text("NAME");
    app.add_option("--show", show, "what the picture shows, such as loads,N,V,M,deformed,reactions,labels")
        ->option_text("LIST");
    app.add_option("--case", load_case, "load case or combination to show; default the first")->option_text("ID");
    ui::parse(app, argc, argv);
    if (options.is_headless() && options.files.size() > 1)
        throw ui::OptionsEnd::mistake("frame: found " + std::to_string(options.files.size()) +
                                      " files, wanted one: only a window has room for several");
    if (!units.empty())
        options.settings.units = ui::NamedOption<ui::UnitSystem>{"frame: --units", units, "file, si, kn-m, kn-cm, us",
                                                                 ui::unit_system_named(units)}();
    if (!load_case.empty()) options.load_case = load_case;
    try {
        if (!show.empty()) options.show = parse_show(show);
    } catch (const ShowError& error) {
        throw ui::OptionsEnd::mistake(std::string("frame: ") + error.what());
    }
    return options;
}

} // namespace frame
