#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "femoop/io/reader/model_reader.h"
#include "femoop/io/reader/names.h"
#include "femoop/model/quantity/dof_dimension.h"

namespace femoop {

namespace {

constexpr Keys<5> case_keys{{"id", "self_weight", "nodes", "settlements", "members"}, 1};
constexpr Keys<7> node_load_keys{{"node", "fx", "fy", "fz", "mx", "my", "mz"}, 1};
constexpr Keys<7> settlement_keys{{"node", "ux", "uy", "uz", "rx", "ry", "rz"}, 1};
constexpr Keys<12> distributed_keys{
    {"member", "kind", "qx", "qy", "qz", "mx", "my", "mz", "from", "to", "axes", "projected"}, 2};
constexpr Keys<10> point_keys{{"member", "kind", "at", "fx", "fy", "fz", "mx", "my", "mz", "axes"}, 3};
constexpr Keys<15> end_load_keys{{"member", "kind", "start_fx", "start_fy", "start_fz", "start_mx", "start_my",
                                  "start_mz", "end_fx", "end_fy", "end_fz", "end_mx", "end_my", "end_mz", "axes"},
                                 2};
constexpr Keys<4> temperature_keys{{"member", "kind", "top", "bottom"}, 4};
constexpr Keys<3> misfit_keys{{"member", "kind", "elongation"}, 3};

constexpr std::size_t n_member_loads = names::member_loads.size();

std::optional<Dof> find_line_dof(std::string_view name)
{
    for (const Dof dof : all_dofs)
        if (names::line_loads[index(dof)] == name) return dof;
    return std::nullopt;
}

} // namespace

void ModelReader::read_load_cases(JsonValue list)
{
    for_each(list, {},
             [this](JsonValue value, const Place& place) { model.load_cases.push_back(load_case(value, place)); });
}

LoadCase ModelReader::load_case(JsonValue value, const Place& place)
{
    const auto [id, self_weight, nodes, settlements, members] = reader_.fields(value, case_keys, place);
    LoadCase load_case;
    load_case.id = reader_.id(id, place);
    unreadable_.load_cases.push_back(load_case.id.empty());
    load_case.self_weight = reader_.number(self_weight, place).value_or(0.0);
    read_parts(*this, nodes, place, load_case.nodes, unreadable_.node_loads.emplace_back(), &ModelReader::node_load);
    read_parts(*this, settlements, place, load_case.settlements, unreadable_.settlements.emplace_back(),
               &ModelReader::settlement);
    read_parts(*this, members, place, load_case.members, unreadable_.member_loads.emplace_back(),
               &ModelReader::member_load);
    return load_case;
}

NodeLoad ModelReader::node_load(JsonValue value, const Place& place)
{
    NodeLoad load;
    const auto found = reader_.fields(value, node_load_keys, place);
    load.node = NodeId(reference(found[0], nodes_, place));
    for (const JsonValue part : value)
        if (const auto dof = find_force_dof(part.key()))
            if (auto amount = reader_.quantity(part, force_dimension(*dof), place))
                load.components.push_back({*dof, std::move(*amount)});
    return load;
}

Settlement ModelReader::settlement(JsonValue value, const Place& place)
{
    Settlement settlement;
    const auto found = reader_.fields(value, settlement_keys, place);
    settlement.node = NodeId(reference(found[0], nodes_, place));
    for (const JsonValue part : value)
        if (const auto dof = find_dof(part.key()))
            if (auto amount = reader_.quantity(part, displacement_dimension(*dof), place))
                settlement.components.push_back({*dof, std::move(*amount)});
    return settlement;
}

MemberLoad ModelReader::member_load(JsonValue value, const Place& place)
{
    MemberLoad load;
    if (!reader_.is_object(value, place)) return load;
    const JsonValue kind = field(value, "kind");
    if (!kind.is_present()) reader_.missing_key("kind", place);
    const std::size_t chosen = reader_.choice(kind, names::member_loads, place).value_or(n_member_loads);
    switch (chosen) {
    case 0: load.load = distributed_load(value, place); break;
    case 1: load.load = point_load(value, place); break;
    case 2: load.load = end_loads(value, place); break;
    case 3: load.load = temperature_load(value, place); break;
    case 4: load.load = misfit(value, place); break;
    default: break;
    }
    load.member = MemberId(reference(field(value, "member"), members_, place));
    return load;
}

DistributedLoad ModelReader::distributed_load(JsonValue value, const Place& place)
{
    const auto found = reader_.fields(value, distributed_keys, place);
    DistributedLoad load;
    for (const JsonValue part : value)
        if (const auto dof = find_line_dof(part.key()))
            if (auto amount = line_load(part, *dof, place)) load.values.push_back(std::move(*amount));
    load.from = position(found[8], place);
    load.to = position(found[9], place);
    load.axes = axes(found[10], place);
    load.projected = reader_.boolean(found[11], place);
    return load;
}

std::optional<DistributedLoad::Value> ModelReader::line_load(JsonValue value, Dof dof, const Place& place)
{
    const Dimension dimension = line_load_dimension(dof);
    if (!value.is(JsonKind::Array)) {
        auto amount = reader_.quantity(value, dimension, place);
        if (!amount) return std::nullopt;
        return DistributedLoad::Value{dof, std::move(*amount), std::nullopt};
    }
    const Place here = place.key(value.key());
    if (value.size() != 2) {
        reader_.add({FaultKind::WrongLineLoadSize, {here.text(), std::to_string(value.size())}});
        return DistributedLoad::Value{dof, Quantity(no_number), std::nullopt};
    }
    std::array<Quantity, 2> ends;
    std::size_t i = 0;
    for (const JsonValue entry : value) {
        ends[i] = reader_.quantity(entry, dimension, here.entry(i)).value_or(no_number);
        ++i;
    }
    return DistributedLoad::Value{dof, std::move(ends[0]), std::move(ends[1])};
}

std::optional<Position> ModelReader::position(JsonValue value, const Place& place)
{
    if (!value.is(JsonKind::String) || value.text().empty() || value.text().back() != '%') {
        auto length = reader_.quantity(value, dimension::length, place);
        if (!length) return std::nullopt;
        return Position(std::move(*length));
    }
    std::string_view digits = value.text().substr(0, value.text().size() - 1);
    while (!digits.empty() && digits.back() == ' ') digits.remove_suffix(1);
    Percent percent;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), percent.value);
    const bool is_number = error == std::errc() && end == digits.data() + digits.size() && std::isfinite(percent.value);
    if (is_number) return Position(percent);
    reader_.add({FaultKind::BadPercentage, {place.text(value.key()), std::string(value.text())}});
    return Position(Quantity(no_number));
}

PointLoad ModelReader::point_load(JsonValue value, const Place& place)
{
    const auto found = reader_.fields(value, point_keys, place);
    PointLoad load{.at = Quantity(no_number), .components = {}};
    if (auto at = position(found[2], place)) load.at = std::move(*at);
    for (const JsonValue part : value)
        if (const auto dof = find_force_dof(part.key()))
            if (auto amount = reader_.quantity(part, force_dimension(*dof), place))
                load.components.push_back({*dof, std::move(*amount)});
    load.axes = axes(found[9], place);
    return load;
}

EndLoads ModelReader::end_loads(JsonValue value, const Place& place)
{
    constexpr std::string_view at_start = "start_", at_end = "end_";
    const auto found = reader_.fields(value, end_load_keys, place);
    EndLoads loads;
    for (const JsonValue part : value) {
        const bool is_start = part.key().substr(0, at_start.size()) == at_start;
        if (!is_start && part.key().substr(0, at_end.size()) != at_end) continue;
        const auto dof = find_force_dof(part.key().substr(is_start ? at_start.size() : at_end.size()));
        if (!dof) continue;
        if (auto amount = reader_.quantity(part, force_dimension(*dof), place))
            (is_start ? loads.start : loads.end).push_back({*dof, std::move(*amount)});
    }
    loads.axes = axes(found[14], place);
    return loads;
}

TemperatureLoad ModelReader::temperature_load(JsonValue value, const Place& place)
{
    const auto found = reader_.fields(value, temperature_keys, place);
    TemperatureLoad load;
    load.top = reader_.quantity(found[2], dimension::temperature, place).value_or(no_number);
    load.bottom = reader_.quantity(found[3], dimension::temperature, place).value_or(no_number);
    return load;
}

Misfit ModelReader::misfit(JsonValue value, const Place& place)
{
    const auto found = reader_.fields(value, misfit_keys, place);
    return {reader_.quantity(found[2], dimension::length, place).value_or(no_number)};
}

Combination ModelReader::own_combination(JsonValue value, const Place& place)
{
    return combination(value, model.n_cases(), place);
}

} // namespace femoop
