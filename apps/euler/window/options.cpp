#include "apps/euler/window/options.h"

#include <CLI/CLI.hpp>

namespace euler {

Options parse_options(int argc, const char* const* argv, const std::string& version)
{
    Options options;
    const auto add = [&](CLI::App& app) {
        app.add_option_function<std::size_t>(
               "--step", [&](std::size_t step) { options.step = step; },
               "how many steps of the script are done; default all")
            ->option_text("N");
    };
    ui::parse_one_file(
        {.name = "euler",
         .version = version,
         .purpose =
             "Shows Euler operators at work: every step of a script in the picture, "
             "in the tables of the half-edge structure and in the formula of Euler and Poincare, forward and back.",
         .options =
             {.files =
                  "script of Euler operators (.eul) to open; - opens what is redirected here, as a copy without a file",
              .describe = "print the steps and the solids in words and leave; needs no display"}},
        options, argc, argv, add);
    return options;
}

} // namespace euler
