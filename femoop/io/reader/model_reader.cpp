#include "femoop/io/reader/model_reader.h"

#include <algorithm>
#include <utility>

#include "femoop/io/reader/names.h"

namespace femoop {

namespace {

constexpr Keys<20> file_keys{
    {"cremona", "analysis",         "units",    "nodes",      "members",      "title", "notes",
     "mass",    "materials",        "sections", "load_cases", "combinations", "paths", "influence_lines",
     "trains",  "moving_envelopes", "expected", "cross",      "influence",    "train"},
    5};

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
    read_parts(*this, materials, {}, model.materials, unreadable_.materials, &ModelReader::own_material);
    read_parts(*this, sections, {}, model.sections, unreadable_.sections, &ModelReader::section);
    read_parts(*this, nodes, {}, model.nodes, unreadable_.nodes, &ModelReader::node);
    read_parts(*this, members, {}, model.members, unreadable_.members, &ModelReader::member);
    read_load_cases(load_cases);
    read_parts(*this, combinations, {}, model.combinations, unreadable_.combinations, &ModelReader::own_combination);
    read_parts(*this, paths, {}, model.moving_loads.paths, unreadable_.paths, &ModelReader::load_path);
    read_parts(*this, lines, {}, model.moving_loads.influence_lines, unreadable_.influence_lines,
               &ModelReader::influence_line);
    read_parts(*this, trains, {}, model.moving_loads.trains, unreadable_.trains, &ModelReader::train);
    read_parts(*this, envelopes, {}, model.moving_loads.envelopes, unreadable_.moving_envelopes,
               &ModelReader::moving_envelope);
    read_parts(*this, expected, {}, model.expected, unreadable_.expected, &ModelReader::expected);
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
    read_format(cremona);
    if (const auto kind = reader_.choice(analysis, names::analyses, top))
        model.analysis = static_cast<AnalysisKind>(*kind);
    model.units = read_units(units);
    unreadable_.header = reader_.n_troubles() != before || !analysis.is_present() || !units.is_present();
    if (const auto kind = reader_.choice(mass, names::masses, top)) model.mass = static_cast<MassKind>(*kind);
}

void ModelReader::keep_extra_blocks(JsonValue file)
{
    for (const JsonValue value : file) {
        const bool is_extra = std::find(names::extra_blocks.begin(), names::extra_blocks.end(), value.key()) !=
                              names::extra_blocks.end();
        if (is_extra) model.extra.push_back({std::string(value.key()), compact_json(value)});
    }
}

} // namespace femoop
