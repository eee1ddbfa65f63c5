#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <doctest/doctest.h>

#include "femoop/methods/dice.h"
#include "tests/golden/scene.h"
#include "tests/scenarios/script_files.h"
#include "ui/app/headless.h"
#include "ui/paint/surface/golden_text.h"

/// A hand that knows no mercy, in an app's real window off screen: clicks, drags, keys, texts and commands of any kind.
template <class Application> class RandomHand {
public:
    /// \param size  of the window
    RandomHand(Application& application, ui::PixelSize size, std::uint32_t seed)
        : application_(application), size_(size), dice_(seed)
    {}

    void act()
    {
        switch (static_cast<int>(dice_.roll(0, 9))) {
        case 0:
        case 1:
        case 2: press(); break;
        case 3:
        case 4: type(); break;
        case 5:
        case 6: hit_key(); break;
        case 7:
        case 8: run_any_command(); break;
        default: frame({.pointer = anywhere(), .wheel = {0.0, dice_.roll(-3, 3)}}); break;
        }
        frame({.pointer = last_place_});
    }
    /// What it did, in the words of a scenario.
    const std::string& story() const { return story_; }

private:
    ui::Point anywhere()
    {
        last_place_ = {dice_.roll(0, size_.width - 1), dice_.roll(0, size_.height - 1)};
        return last_place_;
    }
    static std::string text_of(ui::Point place)
    {
        return "pixel " + std::to_string(std::lround(place.x)) + ' ' + std::to_string(std::lround(place.y));
    }
    void tell(const std::string& step) { story_ += step + '\n'; }
    void frame(const ui::Input& input) { application_.frame(input); }

    /// A click, or a drag, with either button.
    void press()
    {
        const ui::Point from = anywhere(), to = dice_.roll(0, 2) == 0.0 ? anywhere() : from;
        const bool is_left = dice_.roll(0, 5) > 0.0;
        const ui::Modifiers held{.shift = dice_.roll(0, 4) == 0.0};
        tell((from == to ? "click " + text_of(from) : "drag " + text_of(from) + " to " + text_of(to)) +
             (is_left ? "" : " right") + (held.shift ? " with Shift" : ""));
        const auto at = [&](ui::Point place, bool is_down) {
            frame({.pointer = place, .is_button_down = {is_down && is_left, is_down && !is_left}, .modifiers = held});
        };
        at(from, false);
        at(from, true);
        at(0.5 * (from + to), true);
        at(to, true);
        at(to, false);
    }

    void type()
    {
        static constexpr std::array<const char*, 16> texts{"12",   "-3.5", "1/3", "B",   "0",   "1e9",   "5 kN", "4,5",
                                                           "@2,1", "3<30", "#",   "6;4", "nan", "1e308", "ção",  "mom"};
        const std::string text = dice_.pick(texts);
        tell("type \"" + text + "\"");
        frame({.pointer = last_place_, .text = text});
        if (dice_.roll(0, 2) > 0.0) hit({ui::Key::Enter, {}});
    }

    void hit_key()
    {
        const bool has_ctrl = dice_.roll(0, 3) == 0.0;
        const ui::Modifiers held{.ctrl = has_ctrl, .shift = dice_.roll(0, 3) == 0.0};
        hit({static_cast<ui::Key>(static_cast<int>(dice_.roll(0, ui::n_keys - 1))), held});
    }
    void hit(ui::Chord chord)
    {
        if (const auto* const command = application_.commands().find(chord); command && leaves(command->id)) return;
        tell("key " + text(chord));
        frame({.pointer = last_place_, .modifiers = chord.modifiers, .keys = {{chord.key, true, chord.modifiers}}});
        frame({.pointer = last_place_, .keys = {{chord.key, false}}});
    }

    /// What writes files, or ends the program, is not tried here.
    static bool leaves(std::string_view id) { return id.starts_with("file.") && id != "file.new"; }
    void run_any_command()
    {
        const auto& all = application_.commands().all();
        const auto& command = all[static_cast<std::size_t>(dice_.roll(0, static_cast<int>(all.size()) - 1))];
        if (leaves(command.id)) return;
        tell("command " + std::string(command.id));
        run(command, application_.workspace());
    }

    Application& application_;
    ui::PixelSize size_;
    femoop::Dice dice_;
    ui::Point last_place_{};
    std::string story_;
};

/// Lets some hands work, each on the next of these files, and sees that no picture is spoilt. `CREMONA_SEEDS` gives
/// their number.
template <class Application, class AppStage, class Session>
void let_random_hands_work(const Session& session, const std::vector<std::string>& files)
{
    const char* const many = std::getenv("CREMONA_SEEDS");
    const int n_seeds = many == nullptr ? 4 : std::atoi(many);
    constexpr int n_acts = 80;
    const ui::Fonts fonts;
    for (int seed = 1; seed <= n_seeds; ++seed) {
        const std::filesystem::path file = files[static_cast<std::size_t>(seed) % files.size()];
        const Workplace workplace(file); // a hand may save too
        const ui::PixelSize size = seed % 2 == 0 ? ui::PixelSize{900, 600} : ui::PixelSize{1280, 800};
        golden::if_drawn(
            [&] {
                ui::Offscreen context({.size = size});
                Application application(context, fonts, session);
                AppStage stage(application, context, [](std::string_view, const ui::Pixels&) {});
                CHECK_FALSE(stage.run_command("file.open", file.filename().string()));
                RandomHand<Application> hand(application, size, static_cast<std::uint32_t>(seed));
                for (int i = 0; i < n_acts; ++i) {
                    hand.act();
                    CAPTURE(seed);
                    CAPTURE(file.string());
                    CAPTURE(hand.story());
                    const auto& picture = application.canvas().picture();
                    if (!picture) continue;
                    CHECK(picture->n_refused() == 0);
                    const std::string words = ui::golden_text(*picture);
                    CHECK(words.find("nan\"") == std::string::npos);
                    CHECK(words.find("inf\"") == std::string::npos);
                }
                return context.pixels();
            },
            golden::this_machine());
    }
}
