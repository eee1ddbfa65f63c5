#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "ui/text/message.h"

namespace ui {

/// The endings of the kinds of files that something is written to: ".png", ".report.pdf".
using Endings = std::span<const std::string>;

/// A name ends in it, in letters of either case.
bool has_ending(const std::filesystem::path& file, std::string_view ending);
/// Nothing where a file's name has one of the endings, else what is wanted.
std::optional<Message> why_not_ending(const std::filesystem::path& file, Endings endings);

} // namespace ui
