#include "femoop/io/reader/file_reader.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "femoop/io/reader/names.h"
#include "femoop/model/check/suggestion.h"

namespace femoop {

namespace {

constexpr double format = 1.0;
constexpr Keys<2> units_keys{{"length", "force"}, 2};
constexpr Keys<7> material_keys{{"id", "E", "nu", "G", "alpha", "density", "fy"}, 2};
constexpr Keys<n_dofs> spring_keys{names::displacements, 0};
constexpr Keys<2> combination_keys{{"id", "factors"}, 2};

} // namespace

void FileReader::read_format(JsonValue cremona)
{
    const auto found = reader_.number(cremona, {});
    if (found && *found != format) reader_.add({FaultKind::UnknownFormat, {compact_json(cremona)}});
}

Units FileReader::read_units(JsonValue value)
{
    Units units;
    const Place top;
    if (!reader_.is_object(value, top)) return units;
    const Place here = top.key("units");
    const auto [length, force] = reader_.fields(value, units_keys, here);
    if (const auto unit = reader_.choice(length, names::lengths, here)) units.length = static_cast<LengthUnit>(*unit);
    if (const auto unit = reader_.choice(force, names::forces, here)) units.force = static_cast<ForceUnit>(*unit);
    reader_.set_units(units);
    return units;
}

std::string_view FileReader::id_of(JsonValue entry)
{
    if (!entry.is(JsonKind::Object)) return {};
    for (const JsonValue value : entry)
        if (value.key() == "id") return value.is(JsonKind::String) ? value.text() : std::string_view();
    return {};
}

void FileReader::NameTable::add(JsonValue list, std::size_t first_index)
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

bool FileReader::NameTable::is_lost_entry(std::string_view name, std::size_t index) const
{
    const auto entry = entries.find(name);
    return entry == entries.end() || entry->second != index;
}

bool FileReader::NameTable::excuses(std::string_view name, std::size_t n_own)
{
    if (is_lost || excused.contains(name)) return true;
    return excused.size() + n_own < n_lost && excused.insert(name).second;
}

std::size_t FileReader::reference(JsonValue value, NameTable& names, const Place& place)
{
    if (!value.is_present()) return nowhere;
    if (!value.is(JsonKind::String)) {
        reader_.wrong_type(value, {translatable("the id of an entry, a text"), "\"A\""}, place);
        return nowhere;
    }
    return lookup(value.text(), names, place);
}

std::size_t FileReader::lookup(std::string_view id, NameTable& names, const Place& place, std::size_t n_own)
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

JsonValue FileReader::field(JsonValue object, std::string_view key)
{
    if (!object.is(JsonKind::Object)) return {};
    for (const JsonValue value : object)
        if (value.key() == key) return value;
    return {};
}

Material FileReader::material(JsonValue value, const Place& place)
{
    const auto [id, E, nu, G, alpha, density, fy] = reader_.fields(value, material_keys, place);
    Material material;
    material.id = reader_.id(id, place);
    material.E = reader_.quantity(E, dimension::stress, place).value_or(no_number);
    material.nu = reader_.quantity(nu, dimension::none, place);
    material.G = reader_.quantity(G, dimension::stress, place);
    material.alpha = reader_.quantity(alpha, dimension::expansion, place);
    material.density = reader_.quantity(density, dimension::density, place);
    material.fy = reader_.quantity(fy, dimension::stress, place);
    return material;
}

DofSet FileReader::dof_set(JsonValue value, const Place& place)
{
    if (!reader_.is_list(value, place)) return {};
    const Place here = place.key(value.key());
    std::array<std::optional<std::size_t>, n_dofs> seen;
    DofSet dofs;
    std::size_t i = 0;
    for (const JsonValue entry : value) {
        const Place own_place = here.entry(i);
        if (const auto dof = reader_.choice(entry, names::displacements, own_place)) {
            if (auto& first = seen[*dof])
                reader_.add({FaultKind::RepeatedDof,
                             {own_place.text(), std::string(names::displacements[*dof]), here.entry(*first).text()}});
            else first = i;
            dofs.insert(all_dofs[*dof]);
        }
        ++i;
    }
    return dofs;
}

std::vector<Spring> FileReader::springs(JsonValue value, Dimension (*dimension_of)(Dof), const Place& place)
{
    std::vector<Spring> springs;
    if (!value.is_present()) return springs;
    const Place here = place.key(value.key());
    reader_.fields(value, spring_keys, here);
    for (const JsonValue entry : value)
        if (const auto dof = find_dof(entry.key()))
            if (auto stiffness = reader_.quantity(entry, dimension_of(*dof), here))
                springs.push_back({*dof, std::move(*stiffness)});
    return springs;
}

LoadAxes FileReader::axes(JsonValue value, const Place& place)
{
    const auto chosen = reader_.choice(value, names::axes, place);
    return chosen ? static_cast<LoadAxes>(*chosen) : LoadAxes::Global;
}

Combination FileReader::combination(JsonValue value, std::size_t index, const Place& place)
{
    const auto [id, factors] = reader_.fields(value, combination_keys, place);
    Combination combination;
    combination.id = reader_.id(id, place);
    if (!reader_.is_object(factors, place)) return combination;
    const Place here = place.key("factors");
    const bool is_lost = cases_.is_lost_entry(combination.id, index);
    for (const JsonValue factor : factors) {
        const auto number = reader_.number(factor, here);
        const std::size_t of = lookup(factor.key(), cases_, place, is_lost ? 1 : 0);
        if (number) combination.terms.push_back({CaseId(of), *number});
    }
    return combination;
}

} // namespace femoop
