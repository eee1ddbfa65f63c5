#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "ui/command/chord.h"
#include "ui/scenario/script.h"

namespace ui {

/// A place in the app's picture in logical pixels, x to the right and y down from the top left corner.
struct PointerPlace {
    double x = 0.0;
    double y = 0.0;

    friend bool operator==(const PointerPlace&, const PointerPlace&) = default;
};

/// What a person does within one frame.
struct InputFrame {
    PointerPlace pointer;
    bool is_left_down = false;
    bool is_right_down = false;
    double wheel = 0.0;
    Modifiers held{};           ///< with the mouse; those of `key` come with it
    std::optional<Chord> key{}; ///< pressed in this frame and released in the next
    std::string text{};         ///< typed

    friend bool operator==(const InputFrame&, const InputFrame&) = default;
};

/// The app as a scenario sees it. Whatever goes wrong is said by the return value, as a sentence.
class Stage {
public:
    virtual ~Stage() = default;

    /// The place, or what was wanted instead of these words: "a node of the model: A, B, C".
    using Located = std::variant<PointerPlace, std::string>;
    virtual Located find(std::string_view place) = 0;
    virtual std::optional<std::string> run_command(std::string_view id, std::string_view argument) = 0;
    virtual std::optional<std::string> take_picture(std::string_view name) = 0;
    virtual std::optional<std::string> expect(std::string_view words) = 0;

protected:
    Stage() = default;
    Stage(const Stage&) = default;
    Stage& operator=(const Stage&) = default;
};

/// Plays a script at a fixed time step, so that the same script gives the same frames on every machine.
///
///     while (const auto input = player.next(stage)) app.frame(*input, Player::time_step);
class Player {
public:
    static constexpr double time_step = 1.0 / 60.0; ///< [s]

    explicit Player(std::vector<ScenarioStep> steps) : steps_(std::move(steps)) {}

    /// The input of the next frame; nothing at the end of the script. Commands, pictures and expectations happen in
    /// between, after a frame that shows what the steps before them did.
    /// \throws ScenarioError naming the line
    std::optional<InputFrame> next(Stage& stage);

private:
    void begin(const ScenarioStep& step, Stage& stage);
    void move_to(PointerPlace place);
    void glide_to(PointerPlace place);
    void hold(bool InputFrame::*button, bool is_down);
    void push(double wheel = 0.0);

    std::vector<ScenarioStep> steps_;
    std::size_t next_step_ = 0;
    InputFrame state_; ///< where the pointer is and what is held down
    std::deque<InputFrame> frames_;
};

} // namespace ui
