#include "femoop/io/reader/model_reader.h"

#include <algorithm>
#include <utility>

#include "femoop/io/reader/names.h"
#include "femoop/model/check/suggestion.h"

namespace femoop {

namespace {

constexpr double format = 1.0;
constexpr Keys<20> file_keys{
    {"cremona", "analysis",         "units",    "nodes",      "members",      "title", "notes",
     "mass",    "materials",        "sections", "load_cases", "combinations", "paths", "influence_lines",
     "trains",  "moving_envelopes", "expected", "cross",      "influence",    "train"},
    5};
constexpr Keys<2> units_keys{{"length", "force"}, 2};

} // namespace

ModelReader::ModelReader(JsonValue file, std::vector<Fault> faults)
{
    for (Fault& fault : faults) reader_.add(std::move(fault));
    const Place top;
    const auto [cremona, analysis, units, nodes, members, title, notes, mass, materials, sections, load_cases,
                combinations, paths, lines, trains, envelopes, expected, cross, influence,
                train] = reader_.fields(file, file_keys, top);
    if (!file.is(JsonKind::Object)) {
        unreadable_.header = true;
        return;
    }
    model.title = reader_.text(title, top).value_or("");
    model.notes = reader_.text(notes, top).value_or("");
    read_header(cremona, analysis, units, mass);
    materials_.add(materials);
    sections_.add(sections);
    nodes_.add(nodes);
    members_.add(members);
    cases_.add(load_cases);
    cases_.add(combinations, load_cases.size());
    paths_.add(paths);
    trains_.add(trains);
    nodes_.is_lost = !nodes.is(JsonKind::Array); // without these lists a file has that fault already
    members_.is_lost = !members.is(JsonKind::Array);
    read_parts(materials, {}, model.materials, unreadable_.materials, &ModelReader::material);
    read_parts(sections, {}, model.sections, unreadable_.sections, &ModelReader::section);
    read_parts(nodes, {}, model.nodes, unreadable_.nodes, &ModelReader::node);
    read_parts(members, {}, model.members, unreadable_.members, &ModelReader::member);
    read_load_cases(load_cases);
    read_parts(combinations, {}, model.combinations, unreadable_.combinations, &ModelReader::combination);
    read_parts(paths, {}, model.moving_loads.paths, unreadable_.paths, &ModelReader::load_path);
    read_parts(lines, {}, model.moving_loads.influence_lines, unreadable_.influence_lines,
               &ModelReader::influence_line);
    read_parts(trains, {}, model.moving_loads.trains, unreadable_.trains, &ModelReader::train);
    read_parts(envelopes, {}, model.moving_loads.envelopes, unreadable_.moving_envelopes,
               &ModelReader::moving_envelope);
    read_parts(expected, {}, model.expected, unreadable_.expected, &ModelReader::expected);
    keep_extra_blocks(file);
    unreadable_.is_incomplete = reader_.n_troubles() > 0;
}

ModelReader::ModelReader(const Model& whole)
{
    model.analysis = whole.analysis;
    reader_.set_units(whole.units);
    nodes_.add_parts(whole.nodes);
    members_.add_parts(whole.members);
    cases_.add_parts(whole.load_cases);
    cases_.add_parts(whole.combinations);
    paths_.add_parts(whole.moving_loads.paths);
}

void ModelReader::read_header(JsonValue cremona, JsonValue analysis, JsonValue units, JsonValue mass)
{
    const Place top;
    const std::size_t before = reader_.n_troubles();
    const auto found = reader_.number(cremona, top);
    if (found && *found != format) reader_.add({FaultKind::UnknownFormat, {compact_json(cremona)}});
    if (const auto kind = reader_.choice(analysis, names::analyses, top))
        model.analysis = static_cast<AnalysisKind>(*kind);
    read_units(units);
    unreadable_.header = reader_.n_troubles() != before || !analysis.is_present() || !units.is_present();
    if (const auto kind = reader_.choice(mass, names::masses, top)) model.mass = static_cast<MassKind>(*kind);
}

void ModelReader::read_units(JsonValue units)
{
    const Place top;
    if (!reader_.is_object(units, top)) return;
    const Place here = top.key("units");
    const auto [length, force] = reader_.fields(units, units_keys, here);
    if (const auto unit = reader_.choice(length, names::lengths, here))
        model.units.length = static_cast<LengthUnit>(*unit);
    if (const auto unit = reader_.choice(force, names::forces, here)) model.units.force = static_cast<ForceUnit>(*unit);
    reader_.set_units(model.units);
}

void ModelReader::keep_extra_blocks(JsonValue file)
{
    for (const JsonValue value : file) {
        const bool is_extra = std::find(names::extra_blocks.begin(), names::extra_blocks.end(), value.key()) !=
                              names::extra_blocks.end();
        if (is_extra) model.extra.push_back({std::string(value.key()), compact_json(value)});
    }
}

std::string_view ModelReader::id_of(JsonValue entry)
{
    if (!entry.is(JsonKind::Object)) return {};
    for (const JsonValue value : entry)
        if (value.key() == "id") return value.is(JsonKind::String) ? value.text() : std::string_view();
    return {};
}

void ModelReader::NameTable::add(JsonValue list, std::size_t first_index)
{
    is_lost = is_lost || (list.is_present() && !list.is(JsonKind::Array));
    if (!list.is(JsonKind::Array)) return;
    for (std::size_t i = first_index; const JsonValue entry : list) {
        const std::string_view id = id_of(entry);
        const bool is_new = !id.empty() && entries.emplace(id, i).second;
        if (!is_new) ++n_lost;
        ++i;
    }
}

bool ModelReader::NameTable::is_lost_entry(std::string_view name, std::size_t index) const
{
    const auto entry = entries.find(name);
    return entry == entries.end() || entry->second != index;
}

bool ModelReader::NameTable::excuses(std::string_view name, std::size_t n_own)
{
    if (is_lost || excused.contains(name)) return true;
    return excused.size() + n_own < n_lost && excused.insert(name).second;
}

std::size_t ModelReader::reference(JsonValue value, NameTable& names, const Place& place)
{
    if (!value.is_present()) return nowhere;
    if (!value.is(JsonKind::String)) {
        reader_.wrong_type(value, {translatable("the id of an entry, a text"), "\"A\""}, place);
        return nowhere;
    }
    return lookup(value.text(), names, place);
}

std::size_t ModelReader::lookup(std::string_view id, NameTable& names, const Place& place, std::size_t n_own)
{
    const auto found = names.entries.find(id);
    if (found != names.entries.end()) return found->second;
    if (names.excuses(id, n_own)) {
        reader_.excuse();
        return nowhere;
    }
    // Comparing with every name is slow: in a file with hundreds of errors, only the first ones get a suggestion.
    constexpr std::size_t patience = 100;
    std::vector<std::string_view> known;
    if (reader_.n_troubles() < patience)
        for (const auto& [name, index] : names.entries) known.push_back(name);
    std::sort(known.begin(), known.end());
    auto near = nearest(id, known);
    std::vector<std::string> details{place.text(), std::string(id)};
    if (near) details.push_back(std::move(*near));
    reader_.add({details.size() > 2 ? names.missing_near : names.missing, std::move(details)});
    return nowhere;
}

} // namespace femoop
