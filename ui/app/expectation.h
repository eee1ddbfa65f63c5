#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ui/paint/picture.h"

namespace ui {

/// What was found instead of what a scenario expects, and what was wanted; nothing where it is as expected.
using Complaint = std::optional<std::string>;

Complaint compared(std::string_view what, const std::string& found, const std::string& wanted);

/// The expectations of every app:
///
///     drawn "58.52"     not drawn "58.52"          a whole string of the picture
///     written all.csv "Node;x"     not written …   a file that was written, with this in it
///
/// \returns nothing for words that are none of these, else the complaint
std::optional<Complaint> common_complaint(std::string_view expectation, const std::optional<Picture>& picture);

} // namespace ui
