#pragma once

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

/// One number of the document, which follows every movement of the hand. \pre rows.is_open()
void show_number(const Rows& rows, Desk& desk, ui::NumberFields& fields, const Number& number);

/// All numbers of a part, in a table of their own.
void show_numbers(Desk& desk, ui::NumberFields& fields, const Part& part);

} // namespace frame
