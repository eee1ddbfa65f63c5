#include "ui/app/window_loop.h"

#include <utility>

#include "ui/app/deliver_frame.h"
#include "ui/context/window.h"

namespace ui {

namespace {

bool is_quiet(const Input& input, const std::optional<Point>& pointer_before)
{
    const bool is_down = input.is_button_down[0] || input.is_button_down[1] || input.is_button_down[2];
    return !is_down && input.pointer == pointer_before && input.wheel == Point{} && input.dropped_files.empty();
}

} // namespace

void show_in_window(const AppOptions& options, const MakeApp& make)
{
    const Fonts fonts;
    Window window({.title = "Cremona", .size = *options.settings.window});
    const std::unique_ptr<App> app = make(window, fonts);
    app->gui().set_clipboard({.text = [&] { return window.clipboard(); },
                              .set_text = [&](const std::string& text) { window.set_clipboard(text); }});
    Input others;
    for (std::size_t i = 1; i < options.files.size(); ++i) others.dropped_files.push_back(options.files[i].string());
    app->frame(others);
    constexpr int settling_frames = 3; // widgets settle within these after something happened
    constexpr double patience = 0.3;   // s; a caret blinks at this pace
    int n_due = settling_frames;
    std::optional<Point> pointer;
    std::string title;
    while (!app->wants_to_quit()) {
        const bool must_draw = app->is_moving() || n_due > 0;
        const Input input = window.input(must_draw ? 0.0 : patience);
        const bool is_calm = is_quiet(input, pointer) && window.typing().is_empty();
        n_due = is_calm ? n_due - 1 : settling_frames;
        pointer = input.pointer;
        deliver_frame(*app, input, window.typing());
        if (std::exchange(title, app->window_title()) != title) window.set_title(title);
        window.present();
        if (window.wants_to_close()) {
            window.stay_open();
            app->ask_to_quit();
        }
    }
}

} // namespace ui
