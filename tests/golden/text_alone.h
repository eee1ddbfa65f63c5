#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace golden {

/// The pictures of which the text alone is compared, each with the picture of its kind whose pixels are kept: one picture
/// for every kind, while themes, languages and numbers are held by the strings and their places.
/// \throws std::runtime_error for a list that is not there, or a line without the two names
std::map<std::string, std::string> text_alone(const std::filesystem::path& list);

} // namespace golden
