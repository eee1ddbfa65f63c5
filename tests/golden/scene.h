#pragma once

#include "ui/context/offscreen.h"
#include "ui/context/pixels.h"
#include "ui/paint/paint_to_file.h"

#include <functional>
#include <optional>
#include <string>

namespace golden {

/// Where the tests run: a build server sets the environment variable CI.
enum class Machine { Laptop, BuildServer };
Machine this_machine();

/// What `draw` gives. Where it finds no off-screen renderer (ContextError), nothing: a laptop says so and goes on, on a
/// build server the test fails.
std::optional<ui::Pixels> if_drawn(const std::function<ui::Pixels()>& draw, Machine machine = this_machine());

/// What an app's window is drawn in, off screen: with CREMONA_PICTURES=text, and in a build for browsers, one that draws
/// nothing, since strings and their places alone are compared.
ui::Offscreen offscreen(const ui::Offscreen::Setup& setup);

/// The picture in pixels, if it can be drawn.
std::optional<ui::Pixels> drawn(const ui::Picture& picture, const ui::Fonts& fonts, const ui::Sheet& sheet);

/// For a test: draws the scene off screen and compares picture and text with tests/golden/pictures/NAME.webp and .txt; of
/// what text_alone.txt lists, the text alone.
///
/// Where there is no off-screen renderer the text is compared all the same. Under a sanitizer, or with
/// CREMONA_PICTURES=draw, the scene is drawn and not compared.
void check_scene(const std::string& name, const ui::Sheet& sheet, const ui::Drawing& drawing);

/// The same for a picture that was made elsewhere, such as an app's whole window.
void check_picture(const std::string& name, const ui::Pixels& pixels, const std::string& text);

} // namespace golden
