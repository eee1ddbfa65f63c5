#include "femoop/io/file_text.h"

#include <cerrno>
#include <cstdint>
#include <fstream>
#include <iterator>

#include "femoop/model/fault/translator.h"

namespace femoop {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t most_bytes = 1U << 30U;

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
    case std::errc::read_only_file_system: return std::string(translatable("Read-only file system"));
    default: return std::make_error_code(reason).message();
    }
}

FileText refused(const fs::path& path, std::errc reason)
{
    return {{}, file_fault(FaultKind::FileUnreadable, path, reason)};
}

} // namespace

Fault file_fault(FaultKind kind, const fs::path& path, std::errc reason)
{
    return {kind, {path.string(), reason_text(reason)}};
}

FileText file_text(const fs::path& path)
{
    std::error_code unknown;
    const fs::file_status status = fs::status(path, unknown);
    if (fs::is_directory(status)) return refused(path, std::errc::is_a_directory);
    if (fs::exists(status) && !fs::is_regular_file(status))
        return {{}, Fault{FaultKind::FileUnreadable, {path.string(), std::string(translatable("Not a regular file"))}}};
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    const auto reason = static_cast<std::errc>(errno);
    if (!file) return refused(path, reason);
    if (fs::file_size(path, unknown) > most_bytes && !unknown) return refused(path, std::errc::file_too_large);
    try {
        return {{std::istreambuf_iterator<char>(file), {}}, std::nullopt};
    } catch (const std::ios_base::failure&) {
        return refused(path, std::errc::io_error);
    }
}

} // namespace femoop
