#include "apps/frame/window/options.h"
#include "apps/frame/window/run.h"
#include "apps/version.h"
#include "ui/app/program.h"

int main(int argc, char** argv)
{
    ui::run_program("frame", [&] { return frame::run(frame::parse_options(argc, argv, CREMONA_VERSION)); });
}
