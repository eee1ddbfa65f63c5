#include "apps/euler/window/options.h"

#include <charconv>

namespace euler {

Options parse_options(int argc, const char* const* argv, const std::string& version)
{
    Options options;
    const ui::CommandLine::Option step{
        "--step", "N", "how many steps of the script are done; default all", [&](const std::string& text) {
            std::size_t n = 0;
            const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
            if (error != std::errc() || end != text.data() + text.size())
                throw ui::OptionsEnd::mistake("euler: --step: found \"" + text + "\", wanted a whole number from 0");
            options.step = n;
        }};
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
        options, argc, argv, {step});
    return options;
}

} // namespace euler
