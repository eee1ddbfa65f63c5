#include "ui/app/window_loop.h"

#include <memory>
#include <utility>

#include "ui/app/deliver_frame.h"
#include "ui/context/frame_loop.h"
#include "ui/context/offered_app.h"
#include "ui/context/window.h"

namespace ui {

namespace {

bool is_quiet(const Input& input, const std::optional<Point>& pointer_before)
{
    const bool is_down = input.is_button_down[0] || input.is_button_down[1] || input.is_button_down[2];
    return !is_down && input.pointer == pointer_before && input.wheel == Point{} && input.dropped_files.empty();
}

/// An app in its window, frame by frame.
class ShownApp {
public:
    ShownApp(const AppOptions& options, const MakeApp& make)
        : window_({.title = "Cremona", .size = *options.settings.window}), app_(make(window_, fonts_))
    {
        app_->gui().set_clipboard({.text = [this] { return window_.clipboard(); },
                                   .set_text = [this](const std::string& text) { window_.set_clipboard(text); }});
        Input others;
        for (std::size_t i = 1; i < options.files.size(); ++i)
            others.dropped_files.push_back(options.files[i].string());
        app_->frame(others);
    }

    /// A frame, once there is something to show. \returns whether the app goes on
    bool step()
    {
        if (app_->wants_to_quit()) return false;
        const bool must_draw = app_->is_moving() || n_due_ > 0;
        if (window_.wait(must_draw ? 0.0 : patience)) show_frame();
        return true;
    }

private:
    static constexpr int settling_frames = 3; ///< widgets settle within these after something happened
    static constexpr double patience = 0.3;   ///< s; a caret blinks at this pace

    void show_frame()
    {
        const Input input = window_.input();
        const bool is_calm = is_quiet(input, pointer_) && window_.typing().is_empty();
        n_due_ = is_calm ? n_due_ - 1 : settling_frames;
        pointer_ = input.pointer;
        deliver_frame(*app_, input, window_.typing());
        if (std::exchange(title_, app_->window_title()) != title_) window_.set_title(title_);
        window_.present();
        if (window_.wants_to_close()) {
            window_.stay_open();
            app_->ask_to_quit();
        }
    }

    Fonts fonts_;
    Window window_;
    std::unique_ptr<App> app_;
    OfferedApp offered_app_{{.copy = [this] { return app_->copy_of_document(); },
                             .description = [this] { return app_->document_in_words(); },
                             .results = [this] { return app_->results_text(); },
                             .replace =
                                 [this](const std::filesystem::path& file) {
                                     n_due_ = settling_frames;
                                     return app_->replace_document(file);
                                 },
                             .run_command =
                                 [this](const std::string& id, const std::string& argument) {
                                     n_due_ = settling_frames;
                                     return app_->run_command(id, argument);
                                 }}};
    int n_due_ = settling_frames;
    std::optional<Point> pointer_;
    std::string title_;
};

} // namespace

void show_in_window(const AppOptions& options, const MakeApp& make)
{
    run_frames([app = std::make_shared<ShownApp>(options, make)] { return app->step(); });
}

} // namespace ui
