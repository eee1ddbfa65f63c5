#include "femoop/io/file_text.h"

#include <utility>

#include "femoop/files/whole_file.h"
#include "femoop/model/fault/translator.h"

namespace femoop {

namespace fs = std::filesystem;

namespace {

std::string reason_text(std::errc reason)
{
    switch (reason) {
    case std::errc::no_such_file_or_directory: return std::string(translatable("No such file or directory"));
    case std::errc::permission_denied: return std::string(translatable("Permission denied"));
    case std::errc::is_a_directory: return std::string(translatable("Is a directory"));
    case std::errc::file_too_large: return std::string(translatable("File too large"));
    case std::errc::no_space_on_device: return std::string(translatable("No space left on device"));
    case std::errc::io_error: return std::string(translatable("Input/output error"));
    case std::errc::not_a_directory: return std::string(translatable("Not a directory"));
    case std::errc::filename_too_long: return std::string(translatable("File name too long"));
    case std::errc::operation_not_permitted: return std::string(translatable("Operation not permitted"));
    case std::errc::operation_not_supported: return std::string(translatable("Not a regular file"));
    case std::errc::read_only_file_system: return std::string(translatable("Read-only file system"));
    default: return std::make_error_code(reason).message();
    }
}

} // namespace

Fault file_fault(FaultKind kind, const fs::path& path, std::errc reason)
{
    return {kind, {path.string(), reason_text(reason)}};
}

FileText file_text(const fs::path& path)
{
    files::WholeFile file = files::read_whole_file(path);
    if (file.hindrance) return {{}, file_fault(FaultKind::FileUnreadable, path, std::errc(file.hindrance.value()))};
    return {std::move(file.text), std::nullopt};
}

} // namespace femoop
