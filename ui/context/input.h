#pragma once

#include "ui/command/chord.h"
#include "ui/paint/geometry.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ui {

enum class PointerButton { Left, Right, Middle };
inline constexpr std::size_t n_pointer_buttons = 3;

struct KeyEvent {
    Key key;
    bool is_down;
    Modifiers modifiers{}; ///< held at that moment, which may be over at the end of the frame

    Chord chord() const { return {key, modifiers}; }
};

/// What a person did since the frame before, whether at a window or in a script.
struct Input {
    /// Logical pixels, y down; nothing while the pointer is elsewhere.
    std::optional<Point> pointer{};
    std::array<bool, n_pointer_buttons> is_button_down{};
    /// The hand's seconds, at the least, since the button that goes down now did so before; nothing: the frames' time.
    std::optional<double> since_press{};
    Point wheel{};                ///< notches; positive y is away from the hand
    Modifiers modifiers{};        ///< at the end of the frame
    std::vector<KeyEvent> keys{}; ///< in order
    std::string text{};           ///< typed, UTF-8
    std::vector<std::string> dropped_files{};
    bool has_lost_focus = false;
    double seconds = 1.0 / 60.0; ///< since the frame before
};

} // namespace ui
