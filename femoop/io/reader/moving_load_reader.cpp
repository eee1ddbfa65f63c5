#include <utility>

#include "femoop/io/reader/model_reader.h"
#include "femoop/io/reader/names.h"

namespace femoop {

namespace {

constexpr Keys<2> path_keys{{"id", "members"}, 2};
constexpr Keys<9> line_keys{{"id", "path", "quantity", "node", "member", "component", "at", "side", "load"}, 3};
constexpr Keys<6> load_keys{{"fx", "fy", "fz", "mx", "my", "mz"}, 0};

std::string joined(std::size_t n_quantities)
{
    std::string text;
    for (std::size_t i = 0; i < n_quantities; ++i)
        text += (text.empty() ? "" : ", ") + std::string(names::quantities[i]);
    return text;
}

} // namespace

LoadPath ModelReader::load_path(JsonValue value, const Place& place)
{
    const auto [id, members] = reader_.fields(value, path_keys, place);
    return {.id = reader_.id(id, place), .members = member_list(members, place)};
}

std::vector<MemberId> ModelReader::member_list(JsonValue value, const Place& place)
{
    std::vector<MemberId> members;
    if (!reader_.is_list(value, place)) return members;
    const Place here = place.key(value.key());
    std::size_t i = 0;
    for (const JsonValue name : value) members.emplace_back(reference(name, members_, here.entry(i++)));
    return members;
}

LoadPathReference ModelReader::path_reference(JsonValue value, const Place& place)
{
    if (value.is(JsonKind::Array)) return member_list(value, place);
    if (value.is(JsonKind::String)) return PathId(reference(value, paths_, place));
    if (value.is_present())
        reader_.wrong_type(value, {translatable("the id of a path, or a list of members"), "[\"AB\", \"BC\"]"}, place);
    return std::vector<MemberId>();
}

MovingEffect ModelReader::moving_effect(const EffectFields& fields, ExpectedQuantity last_quantity, const Place& place)
{
    Expected asked;
    const auto chosen = reader_.choice(fields.quantity, names::quantities, place);
    if (chosen) asked.quantity = static_cast<ExpectedQuantity>(*chosen);
    if (chosen && asked.quantity > last_quantity)
        reader_.add({FaultKind::EffectNotMoving,
                     {place.text("quantity"), std::string(names::quantities[*chosen]),
                      joined(static_cast<std::size_t>(last_quantity) + 1)}});
    if (fields.node.is_present()) asked.node = NodeId(reference(fields.node, nodes_, place));
    if (fields.member.is_present()) asked.member = MemberId(reference(fields.member, members_, place));
    if (chosen) read_component(asked, fields.component, place);
    MovingEffect effect{.quantity = asked.quantity,
                        .node = asked.node,
                        .dof = asked.dof,
                        .member = asked.member,
                        .component = asked.component,
                        .at = position(fields.at, place),
                        .side = std::nullopt};
    if (const auto side = reader_.choice(fields.side, names::sides, place)) effect.side = static_cast<Side>(*side);
    return effect;
}

std::vector<Component> ModelReader::unit_load(JsonValue value, const Place& place)
{
    std::vector<Component> components;
    if (!reader_.is_object(value, place)) return components;
    const Place here = place.key(value.key());
    reader_.fields(value, load_keys, here);
    for (const JsonValue part : value)
        if (const auto dof = find_force_dof(part.key()))
            if (auto amount = reader_.quantity(part, dimension::none, here))
                components.push_back({*dof, std::move(*amount)});
    return components;
}

InfluenceLineDefinition ModelReader::influence_line(JsonValue value, const Place& place)
{
    const auto [id, path, quantity, node, member, component, at, side, load] = reader_.fields(value, line_keys, place);
    InfluenceLineDefinition line;
    line.id = reader_.id(id, place);
    line.path = path_reference(path, place);
    line.effect = moving_effect({quantity, node, member, component, at, side}, ExpectedQuantity::SectionForce, place);
    line.load = unit_load(load, place);
    return line;
}

} // namespace femoop
