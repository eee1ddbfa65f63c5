#include "apps/euler/window/run.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <random>
#include <utility>

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

// By hand the challenges are others each time, and files and unsaved work are remembered from one time to the next;
// scenarios and pictures are always the same.
ui::MakeApp app_to_play_with(Session& session, const Options& options, const std::optional<ui::DraftFolder>& folder)
{
    return [&session, &options, &folder](ui::Context& context, const ui::Fonts& fonts) {
        auto app = std::make_unique<Application>(context, fonts, std::move(session));
        app->workspace().next_challenge = std::random_device{}();
        ui::remember(*app, options, folder);
        return app;
    };
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
    return ui::run_app<Application, OffscreenStage>(options, "euler", session,
                                                    app_to_play_with(session, options, folder));
}

} // namespace euler
