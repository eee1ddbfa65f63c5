#include "apps/cross/window/options.h"

namespace cross {

ui::AppOptions parse_options(int argc, const char* const* argv, const std::string& version)
{
    ui::AppOptions options;
    ui::parse_one_file(
        {.name = "cross",
         .version = version,
         .purpose = "Shows moment distribution at work: joints of a beam or plane frame are released by hand, "
                    "one after the other, in the deformed shape, the moment diagram and the calculation sheet.",
         .options = {.files = "model file (.json) to open; - opens what is redirected here, as a copy without a file",
                     .describe = "print the sheet and its results in words and leave; needs no display"}},
        options, argc, argv);
    return options;
}

} // namespace cross
