#pragma once

#include <string>
#include <string_view>

namespace cross {

/// The label of a box or a round button, in as many lines as it needs beside it.
std::string beside_box(std::string_view name, std::string_view id);

} // namespace cross
