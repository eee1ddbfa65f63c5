#include "apps/plane/window/options.h"
#include "apps/plane/window/run.h"
#include "apps/version.h"
#include "ui/app/program.h"

int main(int argc, char** argv)
{
    ui::run_program("plane", [&] { return plane::run(plane::parse_options(argc, argv, CREMONA_VERSION)); });
}
