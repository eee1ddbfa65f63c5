#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace ui {

/// Keys that shortcuts are made of. Letters and digits are those that the key writes.
enum class Key : std::uint8_t {
    A,
    B,
    C,
    D,
    E,
    F,
    G,
    H,
    I,
    J,
    K,
    L,
    M,
    N,
    O,
    P,
    Q,
    R,
    S,
    T,
    U,
    V,
    W,
    X,
    Y,
    Z,
    Digit0,
    Digit1,
    Digit2,
    Digit3,
    Digit4,
    Digit5,
    Digit6,
    Digit7,
    Digit8,
    Digit9,
    F1,
    F2,
    F3,
    F4,
    F5,
    F6,
    F7,
    F8,
    F9,
    F10,
    F11,
    F12,
    Escape,
    Enter,
    Tab,
    Backspace,
    Delete,
    Space,
    Left,
    Right,
    Up,
    Down,
    Home,
    End,
    PageUp,
    PageDown,
    Plus,
    Minus
};
inline constexpr int n_keys = static_cast<int>(Key::Minus) + 1;

struct Modifiers {
    bool ctrl = false;
    bool shift = false;
    bool alt = false;

    friend constexpr bool operator==(const Modifiers&, const Modifiers&) = default;
};

inline constexpr Modifiers no_modifiers{};
inline constexpr Modifiers ctrl{.ctrl = true};
inline constexpr Modifiers shift{.shift = true};
inline constexpr Modifiers ctrl_shift{.ctrl = true, .shift = true};

/// Keys pressed together: Ctrl+Shift+Z.
struct Chord {
    Key key = Key::A;
    Modifiers modifiers;

    friend constexpr bool operator==(const Chord&, const Chord&) = default;
};

std::string text(Chord chord); ///< as keys are marked: "Ctrl+Shift+Z", "Esc", "←"
/// The chord of a text as `text` writes it, letter case aside, or with "Left", "Right", "Up", "Down" for the arrows;
/// nothing for what is none.
std::optional<Chord> chord_typed(std::string_view text);

/// What a field of text does itself: take all, copy, cut, paste, undo, redo.
bool is_edit_of_text(Chord chord);
/// Those of them that a field in which nothing was typed may leave to the document.
bool is_undo_or_redo(Chord chord);
/// What moves between the widgets of a panel that has the keyboard, and presses them: arrows, Home, End, the space bar.
bool is_of_panel(Chord chord);
/// F1 to F12, which no field of text takes.
constexpr bool is_function_key(Key key) { return key >= Key::F1 && key <= Key::F12; }

} // namespace ui
