#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "apps/frame/document/number.h"
#include "apps/frame/session/commands.h"
#include "ui/widgets/number_field.h"

namespace frame {

/// Two columns, names and fields, for the rows of a panel. Rows may be added while `is_open()`.
class Rows {
public:
    explicit Rows(const char* id);
    ~Rows();
    Rows(const Rows&) = delete;
    Rows& operator=(const Rows&) = delete;

    bool is_open() const { return is_open_; }
    /// Begins a row: writes its name, and leaves the field's place as wide as the column.
    void name(const std::string& text) const;

private:
    bool is_open_;
};

/// How the history names the change of something of these parts: "Change qy: Node B", "Change qy: the selection".
ui::Message change_label(const femoop::Model& model, const ui::Message& what, std::span<const Part> parts);

/// The numbers that the parts share but the depths of tapered members, in a table of their own. Each follows every
/// movement of the hand.
/// \param begins  the first of them gets the keyboard now
void show_numbers(Workspace& workspace, ui::NumberFields& fields, std::span<const Part> parts, bool begins = false);

/// Those depths, as rows below the tick that brings them.
void show_depths(const Rows& rows, Workspace& workspace, ui::NumberFields& fields, std::span<const Part> parts);

/// A field of its own for a quantity that is no number of the document, such as a setting of a tool.
struct FieldPlace {
    std::string_view id;
    ui::Measure measure;
    float width = 0.0F; ///< physical pixels; 0: all that is left
    /// Why the quantity cannot have this value; empty where any will do.
    std::function<std::optional<ui::Message>(double)> why_not{};
    bool begins = false; ///< it gets the keyboard now
};
/// \returns whether the quantity was changed
bool edit_quantity(Workspace& workspace, ui::NumberFields& fields, const FieldPlace& place, femoop::Quantity& value);

} // namespace frame
