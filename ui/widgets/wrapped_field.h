#pragma once

#include <string>

namespace ui {

/// A field of several lines in which text is broken where a line is full, as it is typed too. What is broken there is
/// no line of its own in the text. Blanks before a line's end are not kept.
class WrappedField {
public:
    /// So many lines are seen at least and at most, whatever the text has.
    struct Lines {
        int least = 2;
        int most = 4;
    };
    explicit WrappedField(Lines lines) : lines_(lines) {}

    /// As wide as the window. \returns whether another text than `text` was typed to its end
    bool show(const char* id, std::string& text);

private:
    Lines lines_;
    std::string typed_; ///< in lines
    bool is_active_ = false;
};

} // namespace ui
