#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace femoop {

/// Writes JSON text piece by piece, without holding a document: a solution of a million numbers is one string.
///
/// Numbers are the shortest that read back as the same double; -0 is written 0.
/// Errors  a number that is not finite cannot be written: std::domain_error with the key it stands under
class JsonWriter {
public:
    enum class Layout { Line, Block }; ///< all on one line, or one member a line

    JsonWriter& begin_object(Layout layout = Layout::Line);
    JsonWriter& begin_array(Layout layout = Layout::Line);
    JsonWriter& end(); ///< of the innermost object or array
    JsonWriter& key(std::string_view key);
    JsonWriter& value(double number);
    JsonWriter& value(int number);
    JsonWriter& value(std::size_t number);
    JsonWriter& value(std::string_view text);
    JsonWriter& value(const char* text) { return value(std::string_view(text)); }
    JsonWriter& value(bool truth);
    JsonWriter& null();
    JsonWriter& json(std::string_view written); ///< a value that is JSON text already
    /// `key` and `value` at once.
    template <class Value> JsonWriter& member(std::string_view name, const Value& what)
    {
        key(name);
        return value(what);
    }

    /// The finished text with a line break at its end. \pre every object and array was ended
    std::string take();

private:
    struct Level {
        bool is_object = false;
        Layout layout = Layout::Line;
        bool is_empty = true;
    };
    JsonWriter& begin(bool is_object, Layout layout);
    void next_item();
    void new_line();

    std::string text_;
    std::vector<Level> levels_;
    std::string last_key_;
    bool has_key_ = false;
};

} // namespace femoop
