#include "apps/frame/window/run.h"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <utility>

#include "apps/frame/session/recovery.h"
#include "apps/frame/session/session.h"
#include "apps/frame/view/results/mechanism_picture.h"
#include "apps/frame/window/application.h"
#include "apps/frame/window/stage.h"
#include "femoop/result/describe.h"
#include "ui/context/offscreen.h"
#include "ui/context/pixels.h"
#include "ui/context/window.h"

namespace frame {

namespace {

enum ExitStatus : int { Done = 0, AnswerIsNo = 1, BadInput = 2 };

// What the options ask for is in the session; a file that cannot be opened leaves a notice in it.
Session begin(const Options& options)
{
    Session session(starting_document());
    session.set_language(options.language);
    session.view.theme = options.theme;
    session.view.layout = Layout::Overlay;
    if (!options.files.empty()) session.open(options.files.front());
    const bool is_truss = femoop::is_truss(session.model().analysis); // M says nothing there
    session.view.show = options.show.value_or(shown_by_default | ShowSet{is_truss ? Show::N : Show::M});
    session.view.units = options.units;
    return session;
}

void print(const Notice& notice, const ui::Catalogue& tr)
{
    std::cerr << "frame: " << tr(notice.sentence) << '\n';
    for (const femoop::Fault& fault : notice.faults) std::cerr << sentence(fault, tr) << '\n';
}

// Puts the case of the options into the session; false, with a sentence on stderr, if there is none of that name.
bool choose_case(Session& session, const Options& options)
{
    if (!options.load_case) return true;
    if (const auto id = session.model().find_case(*options.load_case)) {
        session.view.load_case = *id;
        return true;
    }
    std::string names;
    for (std::size_t i = 0; i < session.model().n_cases(); ++i)
        names += (i > 0 ? ", " : "") + session.model().case_name(femoop::CaseId(i));
    std::cerr << "frame: "
              << session.view.tr("no load case or combination \"{case}\"; there are: {names}",
                                 {{"case", *options.load_case}, {"names", names}})
              << '\n';
    return false;
}

ui::Offscreen::Setup offscreen_setup(const Options& options)
{
    const auto pixels = [&](double side) { return static_cast<int>(side * options.scale); };
    return {.size = {pixels(options.size.width), pixels(options.size.height)}, .scale = options.scale};
}

int take_screenshot(const Options& options, Session session)
{
    const ui::Fonts fonts;
    ui::Offscreen context(offscreen_setup(options));
    Application application(context, fonts, std::move(session));
    for (int i = 0; i < 3; ++i) application.frame({}); // widgets find their sizes in the first ones
    ui::write_png(*options.screenshot, context.pixels());
    return Done;
}

// Writes frame_00001.png, frame_00002.png and so on.
Film film_in(const std::filesystem::path& folder)
{
    std::filesystem::create_directories(folder);
    return [folder, n = 0](const ui::Pixels& pixels) mutable {
        std::string number = std::to_string(++n);
        number.insert(0, 5 - std::min<std::size_t>(5, number.size()), '0');
        ui::write_png(folder / ("frame_" + number + ".png"), pixels);
    };
}

int play_scenario(const Options& options, Session session)
{
    std::ifstream file(*options.play, std::ios::binary);
    if (!file) {
        std::cerr << "frame: " << session.view.tr("cannot read {file}", {{"file", options.play->string()}}) << '\n';
        return BadInput;
    }
    const std::string script{std::istreambuf_iterator<char>(file), {}};
    const ui::Fonts fonts;
    ui::Offscreen context(offscreen_setup(options));
    Application application(context, fonts, std::move(session));
    const auto keep = [&](std::string_view name, const ui::Pixels& pixels, Application&) {
        std::filesystem::create_directories(options.pictures);
        ui::write_png(options.pictures / (std::string(name) + ".png"), pixels);
    };
    try {
        play(script, context, application, keep, options.frames ? film_in(*options.frames) : Film());
    } catch (const ui::ScenarioError& error) {
        std::cerr << "frame: " << options.play->string() << ": " << error.what() << '\n';
        return AnswerIsNo;
    }
    return Done;
}

bool is_quiet(const ui::Input& input, const std::optional<ui::Point>& pointer_before)
{
    const bool is_down = input.is_button_down[0] || input.is_button_down[1] || input.is_button_down[2];
    return !is_down && input.pointer == pointer_before && input.wheel == ui::Point{} && input.keys.empty() &&
           input.text.empty() && input.dropped_files.empty();
}

int show_window(const Options& options, Session session)
{
    const ui::Fonts fonts;
    ui::Window window({.title = "Cremona", .size = options.size});
    Application application(window, fonts, std::move(session));
    application.gui().set_clipboard({.text = [&] { return window.clipboard(); },
                                     .set_text = [&](const std::string& text) { window.set_clipboard(text); }});
    if (const auto folder = state_folder()) application.remember_in(*folder);
    ui::Input others; // come as files do that are dropped on the window
    for (std::size_t i = 1; i < options.files.size(); ++i) others.dropped_files.push_back(options.files[i].string());
    application.frame(others);
    constexpr int settling_frames = 3; // widgets settle within these after something happened
    constexpr double patience = 0.3;   // s; a caret blinks at this pace
    int n_due = settling_frames;
    std::optional<ui::Point> pointer;
    std::string title;
    while (!application.wants_to_quit()) {
        const bool must_draw = application.is_moving() || n_due > 0;
        const ui::Input input = window.input(must_draw ? 0.0 : patience);
        n_due = is_quiet(input, pointer) ? n_due - 1 : settling_frames;
        pointer = input.pointer;
        application.frame(input);
        if (std::exchange(title, application.window_title()) != title) window.set_title(title);
        window.present();
        if (window.wants_to_close()) {
            window.stay_open();
            application.ask_to_quit();
        }
    }
    return Done;
}

} // namespace

int run(const Options& options)
{
    Session session = begin(options);
    if (options.is_headless() && session.notice) {
        print(*session.notice, session.view.tr);
        if (!session.path()) return BadInput; // else it is about what stands beside the model
    }
    if (!choose_case(session, options)) return BadInput;
    if (options.describe) {
        std::cout << femoop::describe(session.model(), session.solution().results, session.view.tr);
        return Done;
    }
    if (options.play) return play_scenario(options, std::move(session));
    if (options.screenshot) return take_screenshot(options, std::move(session));
    if (!ui::Window::has_display()) {
        std::cerr << "frame: "
                  << session.view.tr("there is no display to open a window on; --screenshot OUT.png draws without one, "
                                     "and so does cremona render")
                  << '\n';
        return BadInput;
    }
    return show_window(options, std::move(session));
}

} // namespace frame
