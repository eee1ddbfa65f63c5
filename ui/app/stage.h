#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "ui/app/headless.h"
#include "ui/context/offscreen.h"
#include "ui/scenario/player.h"

namespace ui {

/// An app as scenarios see it, without a screen. An app adds its places, the commands that take an argument, and what
/// can be expected of it.
template <class Application> class OffscreenStage : public Stage {
public:
    using KeepPicture = std::function<void(std::string_view name, const Pixels&)>;

    OffscreenStage(Application& application, Offscreen& context, KeepPicture keep)
        : application_(application), context_(context), keep_(std::move(keep))
    {}

    std::optional<std::string> take_picture(std::string_view name) override
    {
        keep_(name, context_.pixels());
        return std::nullopt;
    }

protected:
    Application& application() { return application_; }

private:
    Application& application_;
    Offscreen& context_;
    KeepPicture keep_;
};

/// Plays the scenario of the options through the real app. \returns the exit status, as `play_scenario` says
template <class Application, class AppStage, class Session>
int play_through(const AppOptions& options, std::string_view program, const Session& session, const Catalogue& tr)
{
    const Fonts fonts;
    return play_scenario(options, program, tr, [&](const Playing& playing) {
        Application application(playing.context, fonts, session);
        AppStage stage(application, playing.context, playing.keep);
        play(playing.script, playing.context, application, stage, playing.film);
    });
}

} // namespace ui
