#pragma once

#include <imgui.h>

#include <cstdint>
#include <string>

namespace ui {

/// A field of text has the keyboard, or something lies over everything.
bool do_keys_go_elsewhere();
/// What is half typed in a field of text is confirmed where the field is shown next, as by a click elsewhere.
void settle_field();

/// A line of text that keeps the keyboard: after Enter, and after clicks that take it away for a moment. What is typed
/// in the frames until Dear ImGui has given the keyboard back is not lost.
class KeptField {
public:
    enum class Hold : std::uint8_t {
        UntilLeft, ///< Esc drops the text and lets the keyboard go, and a click elsewhere unless a text is half typed
        UntilDone  ///< it has the keyboard as long as it is shown
    };
    /// \param edited  told of every edit, to cut what is too long
    explicit KeptField(Hold hold, ImGuiInputTextCallback edited = nullptr) : hold_(hold), edited_(edited) {}

    /// What is likely typed: the first letter takes its place.
    void offer(std::string text);
    void grab_keyboard() { has_keyboard_ = true; }
    bool has_keyboard() const { return has_keyboard_; }
    const std::string& text() const { return text_; }
    /// \returns whether Enter was pressed
    bool show(const char* id, const std::string& hint = "");

private:
    static int on_event(ImGuiInputTextCallbackData* data);
    void place_cursor(ImGuiInputTextCallbackData& data) const;
    bool take_early_keys();

    Hold hold_;
    ImGuiInputTextCallback edited_;
    std::string text_;
    bool is_offered_ = false;   ///< and nothing was typed yet
    bool has_keyboard_ = false; ///< or is about to get it back
    bool is_active_ = false;    ///< Dear ImGui has given it the keyboard
    bool is_placed_ = true;     ///< the cursor, since then
    int n_waited_ = 0;          ///< frames, since it was asked for
};

} // namespace ui
