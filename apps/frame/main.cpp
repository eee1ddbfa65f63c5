#include "apps/frame/window/options.h"
#include "apps/frame/window/run.h"
#include "ui/app/program.h"
#include "version.h"

int main(int argc, char** argv)
{
    ui::run_program("frame", [&] { return frame::run(frame::parse_options(argc, argv, CREMONA_VERSION)); });
}
