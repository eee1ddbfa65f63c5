#include "apps/euler/window/run.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <random>

#include "apps/euler/window/application.h"
#include "apps/euler/window/describe.h"
#include "apps/euler/window/stage.h"
#include "ui/app/headless.h"
#include "ui/app/window_loop.h"
#include "ui/context/window.h"

namespace euler {

namespace {

enum ExitStatus : int { Done = 0, BadInput = 2 };

// What the options ask for is in the session; a file that cannot be opened leaves a notice in it.
Session begin(const Options& options)
{
    Session session;
    session.look.theme = options.theme;
    session.look.tr = ui::Catalogue(options.language);
    if (!options.files.empty()) session.open(options.files.front());
    if (options.step) session.go_to(std::min(*options.step, session.n_steps()));
    return session;
}

int play_scenario(const Options& options, const Session& session)
{
    const ui::Fonts fonts;
    return ui::play_scenario(options, "euler", session.tr(), [&](const ui::Playing& playing) {
        Application application(playing.context, fonts, session);
        OffscreenStage stage(playing.context, application, playing.keep);
        ui::play(playing.script, playing.context, application, stage, playing.film);
    });
}

ui::MakeApp app_with(const Session& session)
{
    return [session](ui::Context& context, const ui::Fonts& fonts) {
        return std::make_unique<Application>(context, fonts, session);
    };
}

// By hand the challenges are others each time; scenarios and pictures are always the same.
ui::MakeApp app_to_play_with(const Session& session)
{
    return [session](ui::Context& context, const ui::Fonts& fonts) {
        auto app = std::make_unique<Application>(context, fonts, session);
        app->desk().next_challenge = std::random_device{}();
        return app;
    };
}

int complain(const std::string& sentence)
{
    std::cerr << "euler: " << sentence << '\n';
    return BadInput;
}

} // namespace

int run(const Options& options)
{
    const Session session = begin(options);
    if (options.is_headless() && session.notice) return complain(session.tr()(session.notice->sentence));
    if (options.describe) {
        std::cout << in_words(session);
        return Done;
    }
    if (options.play) return play_scenario(options, session);
    if (options.screenshot) {
        ui::take_screenshot(options, app_with(session));
        return Done;
    }
    if (!ui::Window::has_display())
        return complain(
            session.tr()("there is no display to open a window on; --screenshot OUT.png draws without one"));
    ui::show_in_window(options, app_to_play_with(session));
    return Done;
}

} // namespace euler
