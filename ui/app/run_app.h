#pragma once

#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string_view>

#include "ui/app/stage.h"
#include "ui/app/window_loop.h"
#include "ui/context/window.h"
#include "ui/files/draft.h"
#include "ui/text/printable.h"

namespace ui {

/// Makes the app with a copy of the session.
template <class Application, class Session> MakeApp app_with(const Session& session)
{
    return [session](Context& context, const Fonts& fonts) {
        return std::make_unique<Application>(context, fonts, session);
    };
}

/// Opens a file, or of "-" what is redirected to the program, as a copy without a file.
template <class Session> void open_first(Session& session, const std::filesystem::path& file)
{
    if (file == "-") session.open_copy("/dev/stdin");
    else session.open(file);
}

/// The same in a window, where it remembers files and unsaved work from one time to the next.
template <class Application, class Session>
MakeApp remembering_app_with(const Session& session, const std::optional<DraftFolder>& folder)
{
    return [session, folder](Context& context, const Fonts& fonts) {
        auto application = std::make_unique<Application>(context, fonts, session);
        if (folder) application->remember_in(*folder);
        return application;
    };
}

/// Runs an app of one document as the options say: in a window, which `in_window` makes, for one screenshot, in words,
/// or through a scenario. What the options ask for is in the session; of a file that could not be opened its notice
/// tells. \returns the exit status: 0 done, 1 a scenario did not go as it expects, 2 bad input or no display
template <class Application, class AppStage, class Session>
int run_app(const AppOptions& options, std::string_view program, const Session& session, const MakeApp& in_window)
{
    constexpr int done = 0, bad_input = 2;
    const auto complain = [&](const Phrase& sentence) {
        std::cerr << program << ": " << printable(session.tr()(sentence)) << '\n';
        return bad_input;
    };
    if (options.is_headless() && session.notice) return complain(session.notice->sentence);
    if (options.describe) {
        std::cout << printable(in_words(session));
        return done;
    }
    if (options.play) return play_through<Application, AppStage>(options, program, session, session.tr());
    if (options.screenshot) {
        take_screenshot(options, app_with<Application>(session));
        return done;
    }
    if (!Window::has_display())
        return complain(
            translatable("there is no display to open a window on; --screenshot OUT.png draws without one"));
    show_in_window(options, in_window);
    return done;
}

/// The same of an app whose options name a file at most. `folder`: where it keeps its drafts
template <class Application, class AppStage, class Session>
int run_with(const AppOptions& options, std::string_view program, const std::optional<DraftFolder>& folder)
{
    Session session;
    session.look.theme = options.theme;
    session.look.tr = Catalogue(options.language);
    if (!options.files.empty()) open_first(session, options.files.front());
    return run_app<Application, AppStage>(options, program, session,
                                          remembering_app_with<Application>(session, folder));
}

} // namespace ui
