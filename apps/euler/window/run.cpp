#include "apps/euler/window/run.h"

#include <algorithm>
#include <iostream>
#include <random>

#include "apps/euler/window/application.h"
#include "apps/euler/window/describe.h"
#include "apps/euler/window/stage.h"
#include "ui/app/run_app.h"
#include "ui/text/printable.h"

namespace euler {

namespace {

// What the options ask for is in the session; a file that cannot be opened leaves a notice in it.
Session begin(const Options& options)
{
    Session session;
    session.look.theme = *options.settings.theme;
    session.look.tr = ui::Catalogue(*options.settings.language);
    if (!options.files.empty()) ui::open_first(session, options.files.front());
    if (options.step) session.go_to(std::min(*options.step, session.n_steps()));
    return session;
}

} // namespace

int run(Options options)
{
    constexpr int bad_input = 2;
    const auto folder = ui::draft_folder("euler", ".eul");
    ui::complete(options, folder);
    Session session = begin(options);
    if (options.is_headless() && session.script_fault) {
        std::cerr << "euler: " << ui::printable(session.file_name() + ": " + session.tr()(*session.script_fault))
                  << '\n';
        return bad_input;
    }
    // By hand the challenges are others each time; scenarios and pictures are always the same.
    const auto in_window = ui::remembering_app_with<Application>(
        session, options, folder, [](Application& app) { app.workspace().next_challenge = std::random_device{}(); });
    return ui::run_app<Application, OffscreenStage>(options, "euler", session, in_window);
}

} // namespace euler
