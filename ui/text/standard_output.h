#pragma once

#include <optional>
#include <string>

#include "ui/text/message.h"

namespace ui {

/// Writes a text to stdout, its control characters written out (printable.h). \returns why it did not arrive whole,
/// such as a full disk; a reader that goes away before the end has what it wanted.
std::optional<Message> print(std::string text);

} // namespace ui
