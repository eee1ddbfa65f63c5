#include "ui/command/chord.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace ui {

namespace {

constexpr std::array<std::string_view, static_cast<std::size_t>(n_keys)> names{
    "A",   "B",     "C",    "D",     "E",  "F",    "G",    "H",   "I",      "J",        "K",     "L",   "M",
    "N",   "O",     "P",    "Q",     "R",  "S",    "T",    "U",   "V",      "W",        "X",     "Y",   "Z",
    "0",   "1",     "2",    "3",     "4",  "5",    "6",    "7",   "8",      "9",        "F1",    "F2",  "F3",
    "F4",  "F5",    "F6",   "F7",    "F8", "F9",   "F10",  "F11", "F12",    "Esc",      "Enter", "Tab", "Backspace",
    "Del", "Space", "Left", "Right", "Up", "Down", "Home", "End", "PageUp", "PageDown", "+",     "-"};

std::string_view name(Key key) { return names[static_cast<std::size_t>(key)]; }

/// What stands on the key.
std::string_view legend(Key key)
{
    switch (key) {
    case Key::Left: return "←";
    case Key::Right: return "→";
    case Key::Up: return "↑";
    case Key::Down: return "↓";
    default: return name(key);
    }
}

bool is_same(std::string_view a, std::string_view b)
{
    const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](char x, char y) { return lower(x) == lower(y); });
}

bool take_prefix(std::string_view& text, std::string_view prefix)
{
    const bool has_it = text.size() > prefix.size() && is_same(text.substr(0, prefix.size()), prefix);
    if (has_it) text.remove_prefix(prefix.size());
    return has_it;
}

} // namespace

std::string text(Chord chord)
{
    std::string text;
    if (chord.modifiers.ctrl) text += "Ctrl+";
    if (chord.modifiers.shift) text += "Shift+";
    if (chord.modifiers.alt) text += "Alt+";
    return text + std::string(legend(chord.key));
}

bool is_edit_of_text(Chord chord)
{
    constexpr std::array keys{Key::A, Key::C, Key::V, Key::X, Key::Y, Key::Z};
    return chord.modifiers == ctrl && std::ranges::find(keys, chord.key) != keys.end();
}

bool is_of_panel(Chord chord)
{
    if (!(chord.modifiers == Modifiers{})) return false;
    switch (chord.key) {
    case Key::Left:
    case Key::Right:
    case Key::Up:
    case Key::Down:
    case Key::Home:
    case Key::End:
    case Key::Space: return true;
    default: return false;
    }
}

bool is_undo_or_redo(Chord chord) { return chord.modifiers == ctrl && (chord.key == Key::Y || chord.key == Key::Z); }

std::optional<Chord> chord_typed(std::string_view text)
{
    Chord chord;
    chord.modifiers.ctrl = take_prefix(text, "Ctrl+");
    chord.modifiers.shift = take_prefix(text, "Shift+");
    chord.modifiers.alt = take_prefix(text, "Alt+");
    for (int k = 0; k < n_keys; ++k) {
        chord.key = static_cast<Key>(k);
        if (is_same(text, name(chord.key)) || text == legend(chord.key)) return chord;
    }
    return std::nullopt;
}

} // namespace ui
