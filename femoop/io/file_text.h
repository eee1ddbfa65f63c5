#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <system_error>

#include "femoop/model/fault/fault.h"

namespace femoop {

/// What a file holds, or why it cannot be read (femoop/files/whole_file.h).
struct FileText {
    std::string text;
    std::optional<Fault> fault;
};
FileText file_text(const std::filesystem::path& path);

/// That a file cannot be read or written, for the system's reason.
Fault file_fault(FaultKind kind, const std::filesystem::path& path, std::errc reason);

} // namespace femoop
