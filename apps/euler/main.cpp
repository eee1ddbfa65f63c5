#include "apps/euler/window/options.h"
#include "apps/euler/window/run.h"
#include "apps/version.h"
#include "ui/app/program.h"

int main(int argc, char** argv)
{
    ui::run_program("euler", [&] { return euler::run(euler::parse_options(argc, argv, CREMONA_VERSION)); });
}
