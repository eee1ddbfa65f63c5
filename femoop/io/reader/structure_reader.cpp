#include <utility>

#include "femoop/io/reader/model_reader.h"
#include "femoop/io/reader/names.h"
#include "femoop/model/quantity/dof_dimension.h"

namespace femoop {

namespace {

constexpr Keys<18> section_keys{{"id", "shape", "profile", "A", "Iz", "Iy", "J", "Asy", "Asz", "h", "yc", "b", "d", "t",
                                 "bf", "tf", "tw", "turned"},
                                1};
constexpr Keys<5> node_keys{{"id", "at", "support", "hinge", "mass"}, 2};
constexpr Keys<3> support_keys{{"fixed", "angle", "springs"}, 0};
constexpr Keys<16> member_keys{{"id", "nodes", "material", "section", "depths", "start", "end", "theory",
                                "inextensible", "unshearable", "rigid", "bar", "tension_only", "compression_only",
                                "foundation", "up"},
                               2};
constexpr Keys<3> end_keys{{"release", "spring", "offset"}, 0};
constexpr Keys<1> foundation_keys{{"y"}, 1};
constexpr Keys<n_dofs> dof_keys{names::displacements, 0};

bool has_depth(SectionShapeKind kind) { return kind != SectionShapeKind::Circle && kind != SectionShapeKind::Tube; }

} // namespace

Section ModelReader::section(JsonValue value, const Place& place)
{
    const auto [id, shape, profile, A, Iz, Iy, J, Asy, Asz, h, yc, b, d, t, bf, tf, tw,
                turned_value] = reader_.fields(value, section_keys, place);
    const auto length = [&](JsonValue field) { return reader_.quantity(field, dimension::length, place); };
    Section section;
    section.id = reader_.id(id, place);
    section.profile = reader_.text(profile, place);
    section.turned = reader_.boolean(turned_value, place);
    section.A = reader_.quantity(A, dimension::area, place);
    section.Iz = reader_.quantity(Iz, dimension::second_moment, place);
    section.Iy = reader_.quantity(Iy, dimension::second_moment, place);
    section.J = reader_.quantity(J, dimension::second_moment, place);
    section.Asy = reader_.quantity(Asy, dimension::area, place);
    section.Asz = reader_.quantity(Asz, dimension::area, place);
    section.yc = length(yc);
    const auto kind = reader_.choice(shape, names::shapes, place);
    if (!kind) {
        section.h = length(h);
        for (const JsonValue size : {b, d, t, bf, tf, tw})
            if (size.is_present() && !shape.is_present())
                reader_.add({FaultKind::SizeWithoutShape, {place.text(), std::string(size.key())}});
        return section;
    }
    SectionShape sizes;
    sizes.kind = static_cast<SectionShapeKind>(*kind);
    (has_depth(sizes.kind) ? sizes.h : section.h) = length(h);
    sizes.b = length(b);
    sizes.d = length(d);
    sizes.t = length(t);
    sizes.bf = length(bf);
    sizes.tf = length(tf);
    sizes.tw = length(tw);
    section.shape = std::move(sizes);
    return section;
}

Node ModelReader::node(JsonValue value, const Place& place)
{
    const auto [id, at, support_value, hinge, mass] = reader_.fields(value, node_keys, place);
    Node node;
    node.id = reader_.id(id, place);
    std::vector<Quantity> coordinates = lengths(at, n_coordinates(model.analysis), place);
    for (std::size_t i = 0; i < coordinates.size(); ++i) node.at[i] = std::move(coordinates[i]);
    node.support = support(support_value, place);
    node.hinge = reader_.boolean(hinge, place);
    const Place masses = place.key("mass");
    if (!mass.is_present()) return node;
    reader_.fields(mass, dof_keys, masses);
    for (const JsonValue part : mass)
        if (const auto dof = find_dof(part.key()))
            if (auto amount = reader_.quantity(part, mass_dimension(*dof), masses))
                node.mass.push_back({*dof, std::move(*amount)});
    return node;
}

std::optional<Support> ModelReader::support(JsonValue value, const Place& place)
{
    if (!value.is_present()) return std::nullopt;
    Support support;
    if (value.is(JsonKind::String)) {
        const auto keyword = reader_.choice(value, names::supports, place);
        if (keyword) support.kind = static_cast<SupportKind>(*keyword + 1); // Custom is the first
        return support;
    }
    if (!value.is(JsonKind::Object)) {
        reader_.wrong_type(value, {translatable("\"fixed\", \"pin\", \"roller\" or an object"), "\"pin\""}, place);
        return std::nullopt;
    }
    const Place here = place.key("support");
    const auto [fixed, angle, spring_list] = reader_.fields(value, support_keys, here);
    support.fixed = dof_set(fixed, here);
    support.angle = reader_.quantity(angle, dimension::angle, here, AngleUnit::Degrees).value_or(0.0);
    support.springs = springs(spring_list, spring_dimension, here);
    return support;
}

std::vector<Quantity> ModelReader::lengths(JsonValue value, std::size_t n, const Place& place)
{
    std::vector<Quantity> lengths;
    if (!reader_.is_list(value, place)) return lengths;
    if (value.size() != n) {
        reader_.add({FaultKind::WrongCoordinateCount,
                     {place.text(value.key()), std::to_string(value.size()), std::to_string(n),
                      std::string(name(model.analysis))}});
        return lengths;
    }
    const Place here = place.key(value.key());
    std::size_t i = 0;
    for (const JsonValue entry : value)
        lengths.push_back(reader_.quantity(entry, dimension::length, here.entry(i++)).value_or(no_number));
    return lengths;
}

Member ModelReader::member(JsonValue value, const Place& place)
{
    const auto [id, nodes, material, section, depths_value, start, end, theory, inextensible, unshearable, rigid, bar,
                tension_only, compression_only, foundation_value, up] = reader_.fields(value, member_keys, place);
    Member member{.nodes = {NodeId(nowhere), NodeId(nowhere)}};
    member.id = reader_.id(id, place);
    if (reader_.is_list(nodes, place) && nodes.size() != 2)
        reader_.add({FaultKind::WrongNodeCount, {place.text(), std::to_string(nodes.size())}});
    else if (nodes.is(JsonKind::Array))
        for (std::size_t i = 0; const JsonValue node : nodes)
            member.nodes[i++] = NodeId(reference(node, nodes_, place));
    if (material.is_present()) member.material = MaterialId(reference(material, materials_, place));
    if (section.is_present()) member.section = SectionId(reference(section, sections_, place));
    member.depths = depths(depths_value, place);
    member.start = member_end(start, place);
    member.end = member_end(end, place);
    if (const auto chosen = reader_.choice(theory, names::theories, place))
        member.theory = static_cast<BeamTheory>(*chosen);
    member.inextensible = reader_.boolean(inextensible, place);
    member.unshearable = reader_.boolean(unshearable, place);
    member.rigid = reader_.boolean(rigid, place);
    member.bar = reader_.boolean(bar, place);
    member.tension_only = reader_.boolean(tension_only, place);
    member.compression_only = reader_.boolean(compression_only, place);
    member.foundation = foundation(foundation_value, place);
    member.up = up_vector(up, place);
    return member;
}

MemberEnd ModelReader::member_end(JsonValue value, const Place& place)
{
    MemberEnd end;
    if (!value.is_present()) return end;
    const Place here = place.key(value.key());
    const auto [release, spring, offset] = reader_.fields(value, end_keys, here);
    end.release = dof_set(release, here);
    end.springs = springs(spring, spring_dimension, here);
    end.offset = lengths(offset, n_coordinates(model.analysis), here);
    return end;
}

std::vector<Quantity> ModelReader::depths(JsonValue value, const Place& place)
{
    if (value.is(JsonKind::Array) && value.size() != 2) {
        reader_.add({FaultKind::DepthCount, {place.text(value.key()), std::to_string(value.size())}});
        return {};
    }
    return quantities(value, dimension::length, place);
}

std::optional<Quantity> ModelReader::foundation(JsonValue value, const Place& place)
{
    if (!value.is_present()) return std::nullopt;
    const Place here = place.key(value.key());
    const auto [y] = reader_.fields(value, foundation_keys, here);
    return reader_.quantity(y, dimension::stress, here);
}

std::vector<Quantity> ModelReader::up_vector(JsonValue value, const Place& place)
{
    std::vector<Quantity> vector;
    if (!reader_.is_list(value, place)) return vector;
    if (value.size() != 3) {
        reader_.add({FaultKind::WrongVectorSize, {place.text(value.key()), std::to_string(value.size())}});
        return vector;
    }
    const Place here = place.key(value.key());
    std::size_t i = 0;
    for (const JsonValue entry : value)
        vector.push_back(reader_.quantity(entry, dimension::none, here.entry(i++)).value_or(no_number));
    return vector;
}

} // namespace femoop
