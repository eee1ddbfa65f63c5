#include "femoop/io/model_file.h"

#include <algorithm>
#include <istream>
#include <iterator>
#include <sstream>
#include <utility>

#include "femoop/files/whole_file.h"
#include "femoop/io/file_text.h"
#include "femoop/io/json/json_document.h"
#include "femoop/io/plane/plane_file.h"
#include "femoop/io/reader/model_reader.h"
#include "femoop/model/check/check_parts.h"
#include "femoop/model/fault/errors_among.h"

namespace femoop {

namespace {

Model sound_model(ModelReading reading)
{
    if (reading.is_sound()) return std::move(reading.model);
    throw ModelError(errors_among(std::move(reading.faults)));
}

Fault plane_elsewhere(JsonValue file)
{
    for (const JsonValue value : file)
        if (value.key() == "analysis" && value.is(JsonKind::String))
            return {FaultKind::PlaneModelElsewhere, {"analysis", std::string(value.text())}};
    return {FaultKind::PlaneModelElsewhere, {"analysis", ""}};
}

std::string contents(std::istream& input)
{
    return {std::istreambuf_iterator<char>(input), std::istreambuf_iterator<char>()};
}

} // namespace

bool ModelReading::is_sound() const { return std::none_of(faults.begin(), faults.end(), is_error); }

ModelReading examine_model(std::string_view text) { return examine_model(parse_json(text)); }

ModelReading examine_model(JsonReading json)
{
    if (!json.document) return {{}, std::move(json.faults)};
    if (plane::is_plane_model(json.document->root())) return {{}, {plane_elsewhere(json.document->root())}};
    ModelReader reader(json.document->root(), std::move(json.faults));
    ModelReading reading{std::move(reader.model), reader.faults()};
    std::vector<Fault> found = check_readable(reading.model, reader.unreadable());
    std::move(found.begin(), found.end(), std::back_inserter(reading.faults));
    return reading;
}

ModelReading examine_model_file(const std::filesystem::path& path)
{
    FileText file = file_text(path);
    if (file.fault) return {{}, {*std::move(file.fault)}};
    return examine_model(file.text);
}

Model read_model(std::string_view text) { return sound_model(examine_model(text)); }
Model read_model(std::istream& input) { return read_model(contents(input)); }
Model read_model_file(const std::filesystem::path& path) { return sound_model(examine_model_file(path)); }

void write_model_file(const Model& model, const std::filesystem::path& path)
{
    const std::error_code error = files::write_whole_file(path, write_model(model));
    if (error) throw ModelError({file_fault(FaultKind::FileUnwritable, path, static_cast<std::errc>(error.value()))});
}

} // namespace femoop
