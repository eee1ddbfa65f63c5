#include "apps/mohr/window/options.h"

namespace mohr {

ui::AppOptions parse_options(int argc, const char* const* argv, const std::string& version)
{
    ui::AppOptions options;
    ui::parse_one_file(
        {.name = "mohr",
         .version = version,
         .purpose =
             "Shows Mohr's circle at work: the element, the circle with its pole, "
             "the curves of the components against the angle, and in space the three circles, all dragged by hand.",
         .options = {.files = "state (.mohr) to open; - opens what is redirected here, as a copy without a file",
                     .describe = "print the state and its results in words and leave; needs no display"}},
        options, argc, argv);
    return options;
}

} // namespace mohr
