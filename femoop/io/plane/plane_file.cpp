#include "femoop/io/plane/plane_file.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "femoop/io/json/json_document.h"
#include "femoop/io/plane/plane_names.h"
#include "femoop/io/plane/plane_reader.h"
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

/// What an entry of `expected` asks for, in the file's words: "case P: stress sx".
std::string asked_for(JsonValue check)
{
    std::string words;
    const auto add = [&](std::string_view key, std::string_view before, std::string_view behind) {
        const JsonValue value = key_of(check, key);
        if (!value.is(JsonKind::String)) return;
        words += (words.empty() ? "" : " ") + std::string(before) + std::string(value.text()) + std::string(behind);
    };
    add("case", "case ", ":");
    for (const std::string_view key : {"analysis", "quantity", "component", "which"}) add(key, "", "");
    return words;
}

PlaneReading drawn_model(JsonValue file, std::vector<Fault> faults)
{
    PlaneReading reading{.model = {}, .faults = std::move(faults), .drawn_checks = {}, .is_drawn = true};
    reading.faults.push_back({FaultKind::PlaneDrawingNotBuilt, {}});
    if (const JsonValue checks = key_of(file, "expected"); checks.is(JsonKind::Array))
        for (const JsonValue check : checks) reading.drawn_checks.push_back(asked_for(check));
    return reading;
}

} // namespace

bool PlaneReading::is_sound() const
{
    return std::ranges::none_of(faults, [](const Fault& fault) { return severity(fault.kind) == Severity::Error; });
}

bool is_plane_model(JsonValue file)
{
    const JsonValue analysis = key_of(file, "analysis");
    return analysis.is(JsonKind::String) &&
           std::ranges::find(names::analyses, analysis.text()) != names::analyses.end();
}

PlaneReading examine_plane_model(JsonValue file, std::vector<Fault> faults)
{
    if (!key_of(file, "elements").is_present()) return drawn_model(file, std::move(faults));
    PlaneReader reader(file, std::move(faults));
    PlaneReading reading{.model = std::move(reader.model), .faults = reader.faults(), .drawn_checks = {}};
    std::ranges::move(check(reading.model, reader.unreadable()), std::back_inserter(reading.faults));
    return reading;
}

PlaneReading examine_plane_model(std::string_view text)
{
    JsonReading json = parse_json(text);
    if (!json.document) return {.model = {}, .faults = std::move(json.faults), .drawn_checks = {}};
    return examine_plane_model(json.document->root(), std::move(json.faults));
}

PlaneModel read_plane_model(std::string_view text)
{
    PlaneReading reading = examine_plane_model(text);
    if (reading.is_sound()) return std::move(reading.model);
    throw ModelError(errors_among(std::move(reading.faults)));
}

} // namespace femoop::plane
