#include "apps/euler/window/run.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <random>
#include <utility>

#include "apps/euler/window/application.h"
#include "apps/euler/window/describe.h"
#include "apps/euler/window/stage.h"
#include "femoop/files/whole_file.h"
#include "ui/app/run_app.h"
#include "ui/app/window_loop.h"
#include "ui/context/window.h"
#include "ui/text/printable.h"

namespace euler {

namespace {

enum ExitStatus : int { Done = 0, BadInput = 2 };

// What the options ask for is in the session; a file that cannot be opened leaves a notice in it.
Session begin(const Options& options)
{
    Session session;
    session.look.theme = *options.settings.theme;
    session.look.tr = ui::Catalogue(*options.settings.language);
    if (!options.files.empty()) session.open(options.files.front());
    if (options.step) session.go_to(std::min(*options.step, session.n_steps()));
    return session;
}

// Of one app, which takes the session over: a lesson of a million steps has no room to be copied.
ui::MakeApp app_with(Session& session)
{
    return [&session](ui::Context& context, const ui::Fonts& fonts) {
        return std::make_unique<Application>(context, fonts, std::move(session));
    };
}

// By hand the challenges are others each time, and files and unsaved work are remembered from one time to the next;
// scenarios and pictures are always the same.
ui::MakeApp app_to_play_with(Session& session, const Options& options, const std::optional<ui::DraftFolder>& folder)
{
    return [&session, &options, &folder](ui::Context& context, const ui::Fonts& fonts) {
        auto app = std::make_unique<Application>(context, fonts, std::move(session));
        app->desk().next_challenge = std::random_device{}();
        ui::remember(*app, options, folder);
        return app;
    };
}

int complain(const std::string& sentence)
{
    std::cerr << "euler: " << ui::printable(sentence) << '\n';
    return BadInput;
}

} // namespace

int run(Options options)
{
    const auto folder = ui::draft_folder("euler", ".eul", files::write_whole_file);
    ui::complete(options, folder);
    Session session = begin(options);
    if (options.is_headless() && session.script_fault)
        return complain(session.file_name() + ": " + session.tr()(*session.script_fault));
    if (options.is_headless() && session.notice) return complain(session.tr()(session.notice->sentence));
    if (options.describe) {
        std::cout << ui::printable(in_words(session));
        return Done;
    }
    if (options.play) return ui::play_through<Application, OffscreenStage>(options, "euler", session, session.tr());
    if (options.screenshot) {
        ui::take_screenshot(options, app_with(session));
        return Done;
    }
    if (!ui::Window::has_display())
        return complain(
            session.tr()("there is no display to open a window on; --screenshot OUT.png draws without one"));
    ui::show_in_window(options, app_to_play_with(session, options, folder));
    return Done;
}

} // namespace euler
