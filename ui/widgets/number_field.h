#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "ui/widgets/keyboard_back.h"
#include "ui/widgets/tab_stops.h"

namespace ui {

/// What a person did to a number field in this frame.
struct NumberFieldEvent {
    enum class Kind : std::uint8_t {
        None,
        Dragged, ///< `value` is new; the gesture goes on
        Settled, ///< the gesture ended
        Typed    ///< `text` was typed and confirmed, and differs from what stood there
    };
    Kind kind = Kind::None;
    double value = 0.0; ///< in the unit shown
    std::string text{};
};

/// Number fields: drag left or right to change the value (Shift: finer), click to type, Enter or a click elsewhere to
/// confirm, Tab and Shift+Tab to go on to the next and the one before, Esc to leave the value as it was. What cannot be
/// understood stays in the field with the reason beneath it, in a window of its own where the field stands in a row with
/// others.
///
/// One object serves all fields of a window: only one can be edited at a time.
class NumberFields {
public:
    struct Look {
        std::string text;            ///< the value as shown, rounded
        std::string exact_text;      ///< the value as it is edited: nothing is lost if it is confirmed as it stands
        std::optional<double> value; ///< nothing: the number is not given, and dragging begins at zero
        bool is_typed_only = false;  ///< such as a name: dragging does not change it
        float width = 0.0F;          ///< physical pixels; 0: all that is left
        bool begins = false;         ///< it gets the keyboard now, as by a click
        bool stays = false;          ///< a click beside the fields confirms nothing half typed: the keyboard comes back
    };

    /// \pre within a window of Dear ImGui's; `id` is unique there
    NumberFieldEvent show(std::string_view id, const Look& look);

    /// Opens the field of this name with a text, as a click does. \pre in the same window of Dear ImGui's as `show`
    void open(std::string_view id, std::string text);
    /// Its text is being edited. \pre as for `open`
    bool is_open(std::string_view id) const;
    /// Enter was pressed in it in this frame, and what stood there was taken, new or not. \pre as for `open`
    bool is_entered(std::string_view id) const;
    /// Says why what was typed last was not taken; the field is opened again with the text.
    void reject(const NumberFieldEvent& event, std::string reason);
    /// Where Tab goes: these fields, and what a window adds.
    TabStops& stops() { return stops_; }
    /// A field has the keyboard. One that is no longer shown has lost it.
    bool is_typing() const;
    /// A field has the keyboard, and nothing was typed into it.
    bool is_untouched() const { return is_typing() && text_ == opening_text_; }

private:
    NumberFieldEvent show_value(unsigned id, const Look& look, float width);
    void open_editor(unsigned id, std::string text);
    NumberFieldEvent show_editor(unsigned id, const Look& look, float width);
    NumberFieldEvent typed(unsigned id, std::string text);
    void show_reason(bool is_in_row) const;
    NumberFieldEvent drag(double start);

    unsigned typing_ = 0;  ///< the field whose text is edited, 0 for none
    int last_shown_ = 0;   ///< the frame in which it was
    int n_openings_ = 0;   ///< of the editor
    bool is_open_ = false; ///< the editor was shown before, so it has the keyboard
    std::string text_;
    std::string opening_text_;
    std::string reason_;
    unsigned last_typed_ = 0;
    unsigned entered_ = 0;   ///< the field that Enter was pressed in
    int frame_entered_ = -1; ///< the frame in which it was
    bool stays_ = false;     ///< the field whose text is edited
    KeyboardBack keyboard_;

    /// A field that stayed open until another was chosen, which confirms it.
    struct Left {
        unsigned id = 0;
        std::string text;
    };
    std::optional<Left> left_;

    TabStops stops_;

    unsigned dragging_ = 0;
    double drag_start_ = 0.0;
    double drag_value_ = 0.0;
    double drag_path_ = 0.0; ///< pixels, those with Shift held counted for a tenth
};

/// The step that a drag of a number changes it by: a hundredth to a tenth of it, as a power of ten or half of one.
double drag_step(double value);

} // namespace ui
