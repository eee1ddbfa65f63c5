#include "apps/euler/window/options.h"

#include <CLI/CLI.hpp>

namespace euler {

namespace {

const ui::OptionWords words{
    .files = "script of Euler operators (.eul) to open",
    .describe = "print the steps and the solids in words and leave; needs no display",
};

} // namespace

Options parse_options(int argc, const char* const* argv)
{
    Options options;
    CLI::App app("Shows Euler operators at work: every step of a script in the picture, in the tables of the half-edge "
                 "structure "
                 "and in the formula of Euler and Poincare, forward and back.",
                 "euler");
    app.set_version_flag("--version", "euler " CREMONA_VERSION);
    ui::add_app_options(app, options, words);
    std::size_t step = 0;
    const auto* const steps =
        app.add_option("--step", step, "how many steps of the script are done; default all")->option_text("N");
    ui::parse(app, argc, argv);
    if (options.files.size() > 1)
        throw ui::OptionsEnd::mistake("euler: found " + std::to_string(options.files.size()) + " files, wanted one");
    if (steps->count() > 0) options.step = step;
    return options;
}

} // namespace euler
