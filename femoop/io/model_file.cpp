#include "femoop/io/model_file.h"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <istream>
#include <iterator>
#include <sstream>
#include <system_error>
#include <utility>

#include "femoop/io/json/json_document.h"
#include "femoop/io/reader/model_reader.h"
#include "femoop/io/whole_file.h"
#include "femoop/model/check/check_parts.h"
#include "femoop/model/fault/translator.h"

namespace femoop {

namespace {

bool is_error(const Fault& fault) { return severity(fault.kind) == Severity::Error; }

Model sound_model(ModelReading reading)
{
    if (reading.is_sound()) return std::move(reading.model);
    auto& faults = reading.faults;
    faults.erase(std::remove_if(faults.begin(), faults.end(), [](const Fault& fault) { return !is_error(fault); }),
                 faults.end());
    throw ModelError(std::move(faults));
}

std::string contents(std::istream& input)
{
    return {std::istreambuf_iterator<char>(input), std::istreambuf_iterator<char>()};
}

std::string reason_text(std::errc reason)
{
    switch (reason) {
    case std::errc::no_such_file_or_directory: return std::string(translatable("No such file or directory"));
    case std::errc::permission_denied: return std::string(translatable("Permission denied"));
    case std::errc::is_a_directory: return std::string(translatable("Is a directory"));
    case std::errc::no_space_on_device: return std::string(translatable("No space left on device"));
    case std::errc::read_only_file_system: return std::string(translatable("Read-only file system"));
    default: return std::make_error_code(reason).message();
    }
}

Fault file_fault(FaultKind kind, const std::filesystem::path& path, std::errc reason)
{
    return {kind, {path.string(), reason_text(reason)}};
}

} // namespace

bool ModelReading::is_sound() const { return std::none_of(faults.begin(), faults.end(), is_error); }

ModelReading examine_model(std::string_view text)
{
    JsonReading json = parse_json(text);
    if (!json.document) return {{}, std::move(json.faults)};
    ModelReader reader(json.document->root(), std::move(json.faults));
    ModelReading reading{std::move(reader.model), reader.faults()};
    std::vector<Fault> found = check_readable(reading.model, reader.unreadable());
    std::move(found.begin(), found.end(), std::back_inserter(reading.faults));
    return reading;
}

ModelReading examine_model_file(const std::filesystem::path& path)
{
    std::error_code unknown;
    if (std::filesystem::is_directory(path, unknown))
        return {{}, {file_fault(FaultKind::FileUnreadable, path, std::errc::is_a_directory)}};
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    const auto reason = static_cast<std::errc>(errno);
    if (!file) return {{}, {file_fault(FaultKind::FileUnreadable, path, reason)}};
    return examine_model(contents(file));
}

Model read_model(std::string_view text) { return sound_model(examine_model(text)); }
Model read_model(std::istream& input) { return read_model(contents(input)); }
Model read_model_file(const std::filesystem::path& path) { return sound_model(examine_model_file(path)); }

void write_model_file(const Model& model, const std::filesystem::path& path)
{
    const std::error_code error = write_whole_file(path, write_model(model));
    if (error) throw ModelError({file_fault(FaultKind::FileUnwritable, path, static_cast<std::errc>(error.value()))});
}

} // namespace femoop
