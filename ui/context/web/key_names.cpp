#include "ui/context/web/key_names.h"

#include "ui/paint/text_measure.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace ui {

namespace {

constexpr std::pair<std::string_view, Key> named_keys[] = {
    {"Escape", Key::Escape}, {"Enter", Key::Enter},         {"Tab", Key::Tab},        {" ", Key::Space},
    {"Delete", Key::Delete}, {"Backspace", Key::Backspace}, {"ArrowLeft", Key::Left}, {"ArrowRight", Key::Right},
    {"ArrowUp", Key::Up},    {"ArrowDown", Key::Down},      {"Home", Key::Home},      {"End", Key::End},
    {"PageUp", Key::PageUp}, {"PageDown", Key::PageDown},   {"+", Key::Plus},         {"=", Key::Plus},
    {"-", Key::Minus}};

Key key_counted(Key first, int offset) { return static_cast<Key>(static_cast<int>(first) + offset); }

std::optional<Key> function_key(std::string_view name)
{
    int number = 0;
    if (!name.starts_with('F')) return std::nullopt;
    const auto [end, error] = std::from_chars(name.data() + 1, name.data() + name.size(), number);
    if (error != std::errc() || end != name.data() + name.size() || number < 1 || number > 12) return std::nullopt;
    return key_counted(Key::F1, number - 1);
}

/// Letters of both cases.
bool is_any_of(std::string_view name, std::string_view letters)
{
    return name.size() == 1 && letters.find(static_cast<char>(name[0] | 0x20)) != std::string_view::npos;
}

} // namespace

std::optional<Key> key_named(std::string_view name)
{
    for (const auto& [theirs, ours] : named_keys)
        if (theirs == name) return ours;
    if (name.size() != 1) return function_key(name);
    const char c = name[0];
    if (c >= 'a' && c <= 'z') return key_counted(Key::A, c - 'a');
    if (c >= 'A' && c <= 'Z') return key_counted(Key::A, c - 'A');
    if (c >= '0' && c <= '9') return key_counted(Key::Digit0, c - '0');
    return std::nullopt;
}

bool is_one_character(std::string_view name) { return decode_utf8(name).size() == 1; }

bool is_of_browser(std::string_view name, const Modifiers& modifiers)
{
    constexpr std::array<std::string_view, 4> alone = {"F5", "F6", "F11", "F12"};
    if (std::ranges::find(alone, name) != alone.end()) return true;
    if (!modifiers.ctrl) return false;
    return is_any_of(name, "rtwnlj") || name == "+" || name == "-" || name == "=" || name == "0" || name == "Tab";
}

bool is_for_clipboard(std::string_view name, const Modifiers& modifiers)
{
    return modifiers.ctrl && is_any_of(name, "cvx");
}

} // namespace ui
