#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "ui/app/app.h"
#include "ui/app/app_options.h"
#include "ui/context/offscreen.h"
#include "ui/scenario/player.h"
#include "ui/text/catalogue.h"

namespace ui {

/// An app without a screen.

/// \pre the settings are complete
Offscreen::Setup offscreen_setup(const AppOptions& options);

/// Draws the app once it has come to rest, and writes the picture. \pre options.screenshot
void take_screenshot(const AppOptions& options, const MakeApp& make);

/// Is given every frame of a scenario.
using Film = std::function<void(const Pixels&)>;
/// Writes frame_00001.png, frame_00002.png and so on.
Film film_in(const std::filesystem::path& folder);

/// Plays a script to its end. \throws ScenarioError
void play(std::string_view script, Offscreen& context, App& app, Stage& stage, const Film& film);

/// What a scenario of the command line is played with.
struct Playing {
    std::string script;
    Offscreen& context;
    std::function<void(std::string_view name, const Pixels&)> keep; ///< a picture
    Film film;
};
/// Reads the scenario that the options name, plays it by `play_it`, and tells on stderr what goes wrong.
/// \returns the exit status: 0 done, 1 it did not go as it expects, 2 it cannot be read. \pre options.play
int play_scenario(const AppOptions& options, std::string_view program, const Catalogue& tr,
                  const std::function<void(const Playing&)>& play_it);

/// Where "pixel 400 300" lies; nothing for other words.
std::optional<PointerPlace> pixel_place(std::string_view words);

} // namespace ui
