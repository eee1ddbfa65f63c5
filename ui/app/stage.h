#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "ui/app/expectation.h"
#include "ui/app/headless.h"
#include "ui/command/command_table.h"
#include "ui/context/imgui_session.h"
#include "ui/context/offscreen.h"
#include "ui/paint/geometry.h"
#include "ui/scenario/player.h"

namespace ui {

/// An app as scenarios see it, without a screen: its commands and `file.export`, which takes a path, and what can be
/// expected of every app (expectation.h). An app adds its places, and by a function of its own
///
///     std::optional<std::string> why_not(std::string_view expectation, Application&);
///
/// what else can be expected of it: what was found instead and what was wanted; nothing where it is so.
template <class Application> class OffscreenStage : public Stage {
public:
    using KeepPicture = std::function<void(std::string_view name, const Pixels&)>;

    OffscreenStage(Application& application, Offscreen& context, KeepPicture keep)
        : application_(application), context_(context), keep_(std::move(keep))
    {}

    Located find(std::string_view place) final
    {
        if (const auto pixel = pixel_place(place)) return *pixel;
        const Found found = locate(place);
        if (const auto* const wanted = std::get_if<std::string>(&found)) return *wanted;
        const Point at = application_.gui().in_window(std::get<Point>(found));
        return PointerPlace{at.x, at.y};
    }
    std::optional<std::string> run_command(std::string_view id, std::string_view argument) override
    {
        if (id != "file.export" || argument.empty())
            return run_by_name(application_.commands(), {id, argument}, application_.workspace());
        const auto reason = application_.export_as(argument);
        return reason ? std::optional(Catalogue()(*reason)) : std::nullopt;
    }
    std::optional<std::string> expect(std::string_view words) override
    {
        if (const auto mismatch = common_mismatch(words, application_, application_.canvas().picture()))
            return *mismatch;
        return why_not(words, application_);
    }
    std::optional<std::string> take_picture(std::string_view name) override
    {
        keep_(name, context_.pixels());
        return std::nullopt;
    }

protected:
    /// A place of the app, as it draws [logical pixels of its ImGuiSession], or what was wanted instead of these words.
    using Found = std::variant<Point, std::string>;
    virtual Found locate(std::string_view place) = 0; ///< but for pixels, which every app knows

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
