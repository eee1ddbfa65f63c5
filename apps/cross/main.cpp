#include "apps/cross/window/options.h"
#include "apps/cross/window/run.h"
#include "apps/version.h"
#include "ui/app/program.h"

int main(int argc, char** argv)
{
    ui::run_program("cross", [&] { return cross::run(cross::parse_options(argc, argv, CREMONA_VERSION)); });
}
