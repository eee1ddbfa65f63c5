#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "ui/command/chord.h"

namespace ui {

/// A script of user input, one step a line; blank lines and those that begin with # are left out.
///
///     click PLACE              presses and releases the left button
///     rightclick PLACE         the same with the right button, which opens a menu
///     hover PLACE              moves the pointer
///     drag PLACE to PLACE      presses, moves in small steps, releases
///     press PLACE              presses and goes on holding the button
///     release                  releases it where the pointer is
///     wheel PLACE TURNS        turns the wheel; positive is away from the hand
///     key CHORD                Ctrl+Z, F, Esc
///     type "TEXT"              \" and \\ stand for themselves
///     command ID [ARGUMENT]    runs a command of the app's table
///     wait SECONDS
///     picture NAME             keeps the picture as it is then
///     expect WORDS             the app checks itself and says what it found instead
///
/// What the mouse does can be done with keys held: `Shift+click node B`, `Alt+drag (2, 0) to (2.3, 1)`.
/// A PLACE is words that the app understands: `node B`, `member AB 50%`, `(2, 0)`, `pixel 400 300`.
/// courseware/reference/scenarios.md says it all.
namespace step {
struct Click {
    std::string at;
    Modifiers held{};
};
struct RightClick {
    std::string at;
    Modifiers held{};
};
struct Hover {
    std::string at;
    Modifiers held{};
};
struct Drag {
    std::string from, to;
    Modifiers held{};
};
struct PressButton {
    std::string at;
    Modifiers held{};
};
struct ReleaseButton {
    Modifiers held{};
};
struct Wheel {
    std::string at;
    double turns = 0.0;
    Modifiers held{};
};
struct Press {
    Chord chord;
};
struct Type {
    std::string text;
};
struct RunCommand {
    std::string id, argument;
};
struct Wait {
    double seconds = 0.0;
};
struct TakePicture {
    std::string name;
};
struct Expect {
    std::string words;
};
} // namespace step

struct ScenarioStep {
    std::size_t line = 0; ///< of the script, from 1
    std::variant<step::Click, step::RightClick, step::Hover, step::Drag, step::PressButton, step::ReleaseButton,
                 step::Wheel, step::Press, step::Type, step::RunCommand, step::Wait, step::TakePicture, step::Expect>
        what;
};

/// What is wrong with a script or went wrong while it was played: `line 3: found "node K", wanted a node of
/// the model: A, B, C`.
class ScenarioError : public std::runtime_error {
public:
    ScenarioError(std::size_t line, const std::string& what)
        : std::runtime_error("line " + std::to_string(line) + ": " + what)
    {}
};

/// \throws ScenarioError for the first line that it does not understand.
std::vector<ScenarioStep> read_scenario(std::string_view text);

} // namespace ui
