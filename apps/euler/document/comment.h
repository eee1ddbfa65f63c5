#pragma once

#include <string>
#include <string_view>

namespace euler {

/// What a script says of a step: the lines of comment just above it, without an empty line between, and the comment at
/// its end, as one paragraph.
std::string comment(std::string_view above, std::string_view line);

/// The paragraph that a text begins with, if that is a comment.
std::string first_comment(std::string_view text);

} // namespace euler
