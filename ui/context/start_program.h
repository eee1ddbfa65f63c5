#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ui/text/message.h"
#include "ui/workspace/export_to_app.h"

namespace ui {

/// Where the program that runs stands, and with it the others of the suite.
std::filesystem::path folder_of_programs();

/// Starts `cremona-program - options...`, which reads the document from its standard input: a file without a name, so that
/// nothing has to be cleared up and nothing can be overwritten. It lives on when this program ends.
/// \returns why it could not be started
std::optional<Message> start_program(const ExportToApp& exported,
                                     const std::filesystem::path& folder = folder_of_programs());

/// This program ends and the other takes its place, its terminal and its number.
/// \returns why it could not be started
std::optional<Message> become_program(const std::string& program, const std::vector<std::string>& arguments,
                                      const std::filesystem::path& folder = folder_of_programs());

} // namespace ui
