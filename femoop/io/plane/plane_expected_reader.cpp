#include <algorithm>
#include <utility>

#include "femoop/io/plane/plane_names.h"
#include "femoop/io/plane/plane_reader.h"
#include "femoop/io/reader/names.h"

namespace femoop::plane {

namespace {

constexpr Keys<16> expected_keys{{"quantity", "value", "case", "analysis", "component", "point", "curve", "region",
                                  "at", "about", "cut", "read", "which", "rtol", "atol", "source"},
                                 2};

std::vector<std::string_view> quantity_words()
{
    std::vector<std::string_view> words;
    for (std::size_t i = 0; i <= static_cast<std::size_t>(PlaneQuantity::Area); ++i)
        words.push_back(name(static_cast<PlaneQuantity>(i)));
    return words;
}

} // namespace

PlaneExpected PlaneReader::expected(JsonValue value, const Place& place)
{
    const auto [quantity, number, load_case, analysis, component, point, curve, region, at, about, cut_value, read,
                which, rtol, atol, source] = reader_.fields(value, expected_keys, place);
    PlaneExpected check;
    const auto chosen = reader_.choice(quantity, quantity_words(), place);
    if (chosen) check.quantity = static_cast<PlaneQuantity>(*chosen);
    if (const auto kind = reader_.choice(analysis, femoop::names::expected_analyses, place))
        check.analysis = static_cast<ExpectedAnalysis>(*kind);
    if (load_case.is_present()) check.load_case = CaseId(reference(load_case, cases_, place));
    if (chosen) read_component(check, component, place);
    if (point.is_present()) check.point = NodeId(reference(point, points_, place));
    if (curve.is_present()) check.curve = CurveId(reference(curve, curves_, place));
    if (region.is_present()) check.region = RegionId(reference(region, regions_, place));
    check.at = location(at, place);
    check.about = location(about, place);
    check.cut = cut(cut_value, place);
    if (const auto reading = reader_.choice(read, names::readings, place))
        check.read = static_cast<StressReading>(*reading);
    read_which(check, which, place);
    check.value = no_number;
    if (chosen) check.value = reader_.quantity(number, dimension_of(check), place).value_or(no_number);
    if (chosen) check.atol = reader_.quantity(atol, dimension_of(check), place);
    check.rtol = reader_.number(rtol, place);
    check.source = reader_.text(source, place).value_or("");
    return check;
}

void PlaneReader::read_component(PlaneExpected& check, JsonValue component, const Place& place)
{
    if (!component.is_present()) return;
    if (check.quantity == PlaneQuantity::Count) {
        if (const auto chosen = reader_.choice(component, names::counted, place))
            check.counted = names::counted[*chosen];
        return;
    }
    const std::vector<PlaneComponent> known = components_of(check.quantity);
    const auto has = [&](PlaneComponent each) { return std::ranges::find(known, each) != known.end(); };
    if (component.is(JsonKind::String) && component.text() == "srt" && has(PlaneComponent::trt)) {
        check.component = PlaneComponent::trt; // another name of it
        return;
    }
    std::vector<std::string_view> words;
    for (const PlaneComponent each : known) words.push_back(name(each));
    if (known.empty()) reader_.unknown_key(component, {"quantity", "value", "case", "rtol", "atol", "source"}, place);
    else if (const auto chosen = reader_.choice(component, words, place)) check.component = known[*chosen];
}

void PlaneReader::read_which(PlaneExpected& check, JsonValue which, const Place& place)
{
    if (!which.is_present()) return;
    if (which.is(JsonKind::String)) {
        if (const auto chosen = reader_.choice(which, femoop::names::extremes, place))
            check.extreme = static_cast<ExtremeKind>(*chosen);
        return;
    }
    constexpr double most = 1e6;
    const auto rank = reader_.number(which, place);
    const bool is_count = rank && *rank >= 1.0 && *rank <= most &&
                          *rank == static_cast<double>(static_cast<int>(*rank));
    if (is_count) check.rank = static_cast<int>(*rank);
    else if (rank) reader_.add({FaultKind::BadMode, {place.text("which"), compact_json(which)}});
}

std::vector<Quantity> PlaneReader::cut(JsonValue value, const Place& place)
{
    std::vector<Quantity> ends;
    if (!value.is_present()) return ends;
    const Place here = place.key(value.key());
    bool is_cut = value.is(JsonKind::Array) && value.size() == 2;
    for (std::size_t i = 0; const JsonValue end : value) {
        is_cut = is_cut && end.is(JsonKind::Array) && end.size() == 2;
        if (!is_cut) break;
        const Place own_place = here.entry(i++);
        for (std::size_t j = 0; const JsonValue coordinate : end)
            ends.push_back(reader_.quantity(coordinate, dimension::length, own_place.entry(j++)).value_or(no_number));
    }
    const bool has_length = ends.size() == 4 && !(ends[0] == ends[2] && ends[1] == ends[3]);
    if (!is_cut || !has_length) {
        reader_.add({FaultKind::CutSize, {here.text()}});
        ends.clear();
    }
    return ends;
}

} // namespace femoop::plane
