#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace femoop {

/// Turns an English text into the reader's language. What has no translation comes back as it is, so
/// `english` (below) is a translator too.
using Translator = std::function<std::string(std::string_view english)>;

inline std::string english(std::string_view text) { return std::string(text); }

} // namespace femoop
