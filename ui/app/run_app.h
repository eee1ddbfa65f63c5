#pragma once

#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ui/app/platform.h"
#include "ui/app/stage.h"
#include "ui/app/window_loop.h"
#include "ui/context/start_program.h"
#include "ui/context/window.h"
#include "ui/files/draft.h"
#include "ui/files/link.h"
#include "ui/text/printable.h"
#include "ui/text/refusal.h"
#include "ui/text/standard_output.h"

namespace ui {

/// Makes one app, which takes the session over: a large document has no room to be copied. \pre the session outlives it
template <class Application, class Session> MakeApp app_with(Session& session)
{
    return [&session](Context& context, const Fonts& fonts) {
        return std::make_unique<Application>(context, fonts, std::move(session));
    };
}

/// Opens a file, or of "-" what is redirected to the program, as a copy without a file.
template <class Session> void open_first(Session& session, const std::filesystem::path& file)
{
    if (file == "-") session.open_copy("/dev/stdin");
    else session.open(file);
}

/// Of what is around the picture only what the options want.
template <class Application> void show_less(Application& application, const AppOptions& options)
{
    if (options.is_bare) application.show_picture_alone();
    if (options.has_no_tools) application.hide_tools();
}

/// The same in a window: it remembers from one time to the next files, unsaved work and how it was left, and starts other
/// programs. \pre the settings are complete \param prepare  what else an app is told there
template <class Application, class Session>
MakeApp remembering_app_with(Session& session, const AppOptions& options, const std::optional<DraftFolder>& folder,
                             const std::function<void(Application&)>& prepare = {})
{
    return [&session, options, folder, prepare](Context& context, const Fonts& fonts) {
        auto application = std::make_unique<Application>(context, fonts, std::move(session));
        begin_as_left(application->workspace(), options.settings);
        show_less(*application, options);
        if (folder) application->remember_in(*folder, options.asked_for);
        if (folder && options.link) application->link_to(Link(*options.link));
        application->start_programs_by([](const ExportToApp& exported) { return start_program(exported); });
        if (prepare) prepare(*application);
        return application;
    };
}

/// What the notice of a session says where there is no window to show it, a sentence a line. An app whose notices hold
/// more has a function of this name.
template <class Session> std::vector<std::string> notice_lines(const Session& session)
{
    return {session.tr()(session.notice->sentence)};
}

/// Whether the notice of what was opened ends a run without a window. An app some of whose notices do not has a
/// function of this name.
template <class Session> bool ends_headless(const Session& /*session*/) { return true; }

/// Why a session cannot be told in words: of most apps any can; one whose own cannot has a function of this name.
template <class Session> std::optional<Refusal> why_no_words(const Session& /*session*/) { return std::nullopt; }

/// Runs an app without a window, for one screenshot, in words, or through a scenario. \returns as `run_app`; nothing: it
/// wants a window
template <class Application, class AppStage, class Session>
std::optional<int> run_headless(const AppOptions& options, std::string_view program, Session& session)
{
    constexpr int done = 0, bad_input = 2;
    if (options.is_headless() && session.notice) {
        std::cerr << program << ": ";
        for (const std::string& line : notice_lines(session)) std::cerr << printable(line) << '\n';
        if (ends_headless(session)) return bad_input;
    }
    if (options.describe) {
        if (const auto refusal = why_no_words(session)) {
            std::cerr << printable(refusal->words);
            return refusal->status;
        }
        const std::optional<Message> fault = print(description(session));
        if (!fault) return done;
        std::cerr << program << ": " << session.tr()(*fault) << '\n';
        return bad_input;
    }
    if (options.play) return play_through<Application, AppStage>(options, program, session, session.tr());
    if (!options.screenshot) return std::nullopt;
    take_screenshot(options, [&](Context& context, const Fonts& fonts) {
        auto application = std::make_unique<Application>(context, fonts, std::move(session));
        show_less(*application, options);
        return application;
    });
    return done;
}

/// Runs an app as the options say: in a window, which `in_window` makes, or without one. What the options ask for is in
/// the session; of a file that could not be opened its notice tells. \returns the exit status: 0 done, 1 a scenario did
/// not go as it expects, 2 bad input or no display, and what a refusal to tell it in words has
template <class Application, class AppStage, class Session>
int run_app(const AppOptions& options, std::string_view program, Session& session, const MakeApp& in_window)
{
    constexpr int done = 0, bad_input = 2;
    if constexpr (requires { session.is_still; }) session.is_still = options.is_still;
    if constexpr (has_terminal)
        if (const auto status = run_headless<Application, AppStage>(options, program, session)) return *status;
    if (!Window::has_display()) {
        const Message sentence = translatable(
            "there is no display to open a window on; --screenshot OUT.png draws without one");
        std::cerr << program << ": " << printable(session.tr()(sentence)) << '\n';
        return bad_input;
    }
    show_in_window(options, in_window);
    return done;
}

/// The same of an app whose options name a file at most. `folder`: where it keeps its drafts and how it was left
/// \param prepare  what else an app is told in a window
template <class Application, class AppStage, class Session>
int run_with(AppOptions options, std::string_view program, const std::optional<DraftFolder>& folder,
             const std::function<void(Application&)>& prepare = {})
{
    complete(options, folder);
    Session session;
    session.look.theme = *options.settings.theme;
    session.look.tr = Catalogue(*options.settings.language);
    if constexpr (requires { session.look.unit_choices; }) {
        session.look.units = options.settings.units;
        session.look.unit_choices = options.settings.unit_choices.value_or(UnitChoices());
    }
    if (!options.files.empty()) open_first(session, options.files.front());
    return run_app<Application, AppStage>(options, program, session,
                                          remembering_app_with<Application>(session, options, folder, prepare));
}

} // namespace ui
