#pragma once

#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "ui/text/catalogue.h"
#include "ui/text/message.h"

namespace ui {

// What an app says of a file: in one wording, whichever app it is.
Message not_opened(const std::filesystem::path& path, const Message& reason);
/// Line by line, and of a long list how many more there are. \pre there is a reason
Message not_opened(const std::filesystem::path& path, const std::vector<Message>& reasons);
Message not_opened(const std::filesystem::path& path, const std::error_code& hindrance);
Message not_saved(const std::filesystem::path& path, const std::error_code& hindrance);
Message saved(const std::filesystem::path& path);
Message not_written(const std::filesystem::path& path, const std::string& reason); ///< an export
/// By the system's reason where it is one, which the catalogue knows.
Message not_written(const std::filesystem::path& path, const std::exception& error);

/// "beam.json", or the word for a document without a file.
std::string file_name(const std::optional<std::filesystem::path>& path, const Catalogue& tr);

} // namespace ui
