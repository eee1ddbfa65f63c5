#pragma once

#include <filesystem>
#include <optional>

#include "ui/text/message.h"
#include "ui/workspace/export_to_app.h"

namespace ui {

/// Where the program that runs stands, and with it the others of the suite.
std::filesystem::path folder_of_programs();

/// Starts `program - options...`, which reads the document from its standard input: a file without a name, so that
/// nothing has to be cleared up and nothing can be overwritten. It lives on when this program ends.
/// \returns why it could not be started
std::optional<Message> start_program(const ExportToApp& exported,
                                     const std::filesystem::path& folder = folder_of_programs());

} // namespace ui
