#include "apps/plane/window/options.h"

namespace plane {

ui::AppOptions parse_options(int argc, const char* const* argv, const std::string& version)
{
    ui::AppOptions options;
    ui::parse_one_file(
        {.name = "plane",
         .version = version,
         .purpose = "Draws plates: lines, arcs and splines whose closed outlines become regions, with materials, "
                    "supports and loads on the geometry, their meshes and stresses.",
         .options = {.files = "drawing (.json) to open; - opens what is redirected here, as a copy without a file",
                     .describe = "print the drawing in words and leave; needs no display"}},
        options, argc, argv);
    return options;
}

} // namespace plane
