#include "femoop/io/plane/plane_file.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "femoop/io/json/json_document.h"
#include "femoop/io/plane/plane_names.h"
#include "femoop/io/plane/plane_reader.h"
#include "femoop/io/reader/names.h"
#include "femoop/model/fault/errors_among.h"
#include "femoop/plane/check/plane_check.h"

namespace femoop::plane {

namespace {

JsonValue key_of(JsonValue object, std::string_view key)
{
    if (!object.is(JsonKind::Object)) return {};
    for (const JsonValue value : object)
        if (value.key() == key) return value;
    return {};
}

} // namespace

bool PlaneReading::is_sound() const { return std::ranges::none_of(faults, is_error); }

bool is_plane_model(JsonValue file)
{
    const JsonValue analysis = key_of(file, "analysis");
    const auto is_among = [analysis](const auto& names) {
        return analysis.is(JsonKind::String) && std::ranges::find(names, analysis.text()) != names.end();
    };
    if (is_among(names::analyses)) return true;
    if (is_among(femoop::names::analyses)) return false;
    const auto has = [file](std::string_view key) { return key_of(file, key).is_present(); };
    return (has("points") || has("curves") || has("regions")) && !has("nodes") && !has("members");
}

PlaneReading examine_plane_model(JsonValue file, std::vector<Fault> faults)
{
    PlaneReader reader(file, std::move(faults));
    PlaneReading reading{.model = std::move(reader.model), .faults = reader.faults()};
    std::ranges::move(check(reading.model, reader.unreadable()), std::back_inserter(reading.faults));
    return reading;
}

PlaneReading examine_plane_model(std::string_view text)
{
    JsonReading json = parse_json(text);
    if (!json.document) return {.model = {}, .faults = std::move(json.faults)};
    return examine_plane_model(json.document->root(), std::move(json.faults));
}

PlaneModel read_plane_model(std::string_view text)
{
    PlaneReading reading = examine_plane_model(text);
    if (reading.is_sound()) return std::move(reading.model);
    throw ModelError(errors_among(std::move(reading.faults)));
}

} // namespace femoop::plane
