#pragma once

#include <string>

namespace ui {

/// Writes a row's name and leaves the cursor where its field begins: in the column that the fields of a panel share, or,
/// in a panel so narrow that the field's text would be cut there, in the line below.
/// \pre the field shows `text` and takes all the width that is left
void begin_field_row(const std::string& name, const std::string& text);

} // namespace ui
