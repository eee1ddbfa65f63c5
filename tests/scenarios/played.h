#pragma once

#include <string>
#include <string_view>

#include "tests/golden/scene.h"
#include "tests/scenarios/script_files.h"
#include "ui/app/headless.h"
#include "ui/paint/surface/golden_text.h"

/// Plays a script in an app's real window off screen; each picture that it takes is compared with the golden one.
/// \returns what went wrong, "" for nothing
template <class Application, class AppStage, class Session>
std::string played_in(const std::string& script, const Session& session, ui::PixelSize size = {1280, 800})
{
    const Workplace workplace;
    const ui::Fonts fonts;
    std::string mismatch;
    golden::if_drawn(
        [&] {
            ui::Offscreen context = golden::offscreen({.size = size});
            Application application(context, fonts, session);
            AppStage stage(application, context, [&](std::string_view name, const ui::Pixels& pixels) {
                golden::check_picture(std::string(name), pixels, ui::golden_text(*application.canvas().picture()));
            });
            try {
                ui::play(script, context, application, stage, {});
            } catch (const ui::ScenarioError& error) {
                mismatch = error.what();
            }
            return context.pixels();
        },
        golden::this_machine());
    return mismatch;
}
