#pragma once

struct ImGuiInputTextCallbackData;

namespace ui {

/// Gives the keyboard back to a field of text that a click elsewhere has taken it from, once nothing else has it, with
/// the cursor behind what was typed.
class KeyboardBack {
public:
    void lose() { is_lost_ = true; }
    void forget() { is_lost_ = false; }
    /// Right before the field, and right after it.
    void before_field();
    void after_field();
    /// Of the field, whose `UserData` is this object. \pre the field has ImGuiInputTextFlags_CallbackAlways
    static int place_cursor(ImGuiInputTextCallbackData* data);

private:
    bool is_lost_ = false;
    bool is_placed_ = true; ///< the cursor, since the keyboard came back
    int n_waited_ = 0;      ///< frames
};

} // namespace ui
