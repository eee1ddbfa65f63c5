#include "ui/app/headless.h"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>

#include "ui/app/deliver_frame.h"
#include "ui/scenario/words.h"
#include "ui/text/number_format.h"
#include "ui/text/printable.h"

namespace ui {

Offscreen::Setup offscreen_setup(const AppOptions& options)
{
    const auto pixels = [&](double side) { return static_cast<int>(side * options.scale); };
    const Size size = *options.settings.window;
    return {.size = {pixels(size.width), pixels(size.height)}, .scale = options.scale};
}

void take_screenshot(const AppOptions& options, const MakeApp& make)
{
    const Fonts fonts;
    Offscreen context(offscreen_setup(options));
    const std::unique_ptr<App> app = make(context, fonts);
    for (int i = 0; i < 3; ++i) app->frame({}); // widgets find their sizes in the first ones
    write_png(*options.screenshot, context.pixels());
}

Film film_in(const std::filesystem::path& folder)
{
    std::filesystem::create_directories(folder);
    return [folder, n = 0](const Pixels& pixels) mutable {
        std::string number = std::to_string(++n);
        number.insert(0, 5 - std::min<std::size_t>(5, number.size()), '0');
        write_png(folder / ("frame_" + number + ".png"), pixels);
    };
}

namespace {

/// The letter or digit that a key writes, as a keyboard sends it along.
std::string written_by(const Chord& chord)
{
    if (chord.modifiers.ctrl || chord.modifiers.alt || chord.key > Key::Digit9) return "";
    const auto from = [&](Key first, char text) {
        return std::string(1, static_cast<char>(text + static_cast<int>(chord.key) - static_cast<int>(first)));
    };
    if (chord.key >= Key::Digit0) return chord.modifiers.shift ? "" : from(Key::Digit0, '0');
    return from(Key::A, chord.modifiers.shift ? 'A' : 'a');
}

/// Turns what a person does within a frame into what the window tells of it, without what is typed.
class InputOfFrame {
public:
    Input operator()(const InputFrame& frame, Typing& typing)
    {
        Input input;
        input.pointer = Point{frame.pointer.x, frame.pointer.y};
        input.is_button_down[static_cast<std::size_t>(PointerButton::Left)] = frame.is_left_down;
        input.is_button_down[static_cast<std::size_t>(PointerButton::Right)] = frame.is_right_down;
        input.wheel = {0.0, frame.wheel};
        input.seconds = Player::time_step;
        input.modifiers = frame.held;
        if (key_held_) typing.add(KeyEvent{*std::exchange(key_held_, std::nullopt), false});
        if (frame.key) {
            input.modifiers = frame.key->modifiers;
            typing.add(KeyEvent{frame.key->key, true, frame.key->modifiers});
            typing.add(written_by(*frame.key));
            key_held_ = frame.key->key;
        }
        typing.add(frame.text);
        return input;
    }

private:
    std::optional<Key> key_held_;
};

} // namespace

void play(std::string_view script, Offscreen& context, App& app, Stage& stage, const Film& film)
{
    Player player(read_scenario(script));
    InputOfFrame input_of;
    Typing typing;
    app.frame({});
    app.frame({});
    while (const auto frame = player.next(stage)) {
        const Input input = input_of(*frame, typing);
        do {
            deliver_frame(app, input, typing);
            if (film) film(context.pixels());
        } while (!typing.is_empty());
    }
}

int play_scenario(const AppOptions& options, std::string_view program, const Catalogue& tr,
                  const std::function<void(const Playing&)>& play_it)
{
    constexpr int done = 0, answer_is_no = 1, bad_input = 2;
    std::error_code unknown;
    const bool is_file = std::filesystem::is_regular_file(*options.play, unknown); // a pipe may never end
    std::ifstream file;
    if (is_file) file.open(*options.play, std::ios::binary);
    if (!file.is_open()) {
        std::cerr << program << ": " << printable(tr("cannot read {file}", {{"file", options.play->string()}})) << '\n';
        return bad_input;
    }
    Offscreen context(offscreen_setup(options));
    const auto keep = [&](std::string_view name, const Pixels& pixels) {
        std::filesystem::create_directories(options.pictures);
        write_png(options.pictures / (std::string(name) + ".png"), pixels);
    };
    try {
        play_it({.script = {std::istreambuf_iterator<char>(file), {}},
                 .context = context,
                 .keep = keep,
                 .film = options.frames ? film_in(*options.frames) : Film()});
    } catch (const ScenarioError& error) {
        std::cerr << program << ": " << printable(options.play->string() + ": " + error.what()) << '\n';
        return answer_is_no;
    }
    return done;
}

std::optional<PointerPlace> pixel_place(std::string_view text)
{
    const std::vector<std::string> words = words_of(text);
    if (words.size() != 3 || words[0] != "pixel") return std::nullopt;
    const auto x = number_typed(words[1]), y = number_typed(words[2]);
    return x && y ? std::optional(PointerPlace{*x, *y}) : std::nullopt;
}

} // namespace ui
