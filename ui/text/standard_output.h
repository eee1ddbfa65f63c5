#pragma once

#include <string>
#include <system_error>

namespace ui {

/// Writes a text to stdout, its control characters written out (printable.h). \returns why it did not arrive whole,
/// such as a full disk; a reader that goes away before the end has what it wanted.
std::error_code print(std::string text);

} // namespace ui
