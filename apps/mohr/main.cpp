#include "apps/mohr/window/options.h"
#include "apps/mohr/window/run.h"
#include "apps/version.h"
#include "ui/app/program.h"

int main(int argc, char** argv)
{
    ui::run_program("mohr", [&] { return mohr::run(mohr::parse_options(argc, argv, CREMONA_VERSION)); });
}
