#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "femoop/io/json/json_document.h"
#include "femoop/io/model_file.h"
#include "femoop/io/reader/names.h"
#include "femoop/io/writer/object_text.h"
#include "femoop/io/writer/part_text.h"

namespace femoop {

namespace {

void add_if(ObjectText& object, std::string_view key, bool value)
{
    if (value) object.add(key, "true");
}

std::string json_text(const Position& position)
{
    if (const auto* const percent = std::get_if<Percent>(&position)) return '"' + json_text(percent->value) + "%\"";
    return json_text(std::get<Quantity>(position));
}

void add_if(ObjectText& object, std::string_view key, const std::optional<Position>& position)
{
    if (position) object.add(key, json_text(*position));
}

void add(ObjectText& object, const SectionShape& shape)
{
    object.add("shape", word(names::shapes, shape.kind));
    add_if(object, "h", shape.h);
    add_if(object, "b", shape.b);
    add_if(object, "d", shape.d);
    add_if(object, "t", shape.t);
    add_if(object, "bf", shape.bf);
    add_if(object, "tf", shape.tf);
    add_if(object, "tw", shape.tw);
}

std::string text_of(const Section& section)
{
    ObjectText object;
    object.add_text("id", section.id);
    if (section.shape) add(object, *section.shape);
    if (section.profile) object.add_text("profile", *section.profile);
    add_if(object, "turned", section.turned);
    add_if(object, "A", section.A);
    add_if(object, "Iz", section.Iz);
    add_if(object, "Iy", section.Iy);
    add_if(object, "J", section.J);
    add_if(object, "Asy", section.Asy);
    add_if(object, "Asz", section.Asz);
    const bool has_own_depth = section.shape && section.shape->h; // then "h" is the shape's, and stands already
    if (!has_own_depth) add_if(object, "h", section.h);
    add_if(object, "yc", section.yc);
    return object.str();
}

std::string text_of(const Support& support, AnalysisKind analysis)
{
    const bool is_turned = support.angle.has_text() || support.angle.value() != 0.0;
    if (support.kind != SupportKind::Custom && !is_turned && support.springs.empty())
        return quoted_json(names::supports.at(static_cast<std::size_t>(support.kind) - 1));
    ObjectText object;
    const DofSet fixed = support.kind == SupportKind::Custom ? support.fixed : support.blocked(analysis);
    if (!fixed.is_empty()) object.add("fixed", text_of(fixed));
    if (is_turned) object.add("angle", support.angle);
    if (!support.springs.empty()) object.add("springs", text_of(support.springs));
    return object.str();
}

void add(ObjectText& object, const std::vector<Component>& components,
         const std::array<std::string_view, n_dofs>& names, const std::string& prefix = "")
{
    for (const Component& component : components)
        object.add(prefix + std::string(names[index(component.dof)]), component.value);
}

std::string text_of(const Node& node, AnalysisKind analysis)
{
    Lines at;
    for (std::size_t i = 0; i < n_coordinates(analysis); ++i) at.push_back(json_text(node.at[i]));
    ObjectText object;
    object.add_text("id", node.id).add("at", json_list(at));
    if (node.support) object.add("support", text_of(*node.support, analysis));
    add_if(object, "hinge", node.hinge);
    ObjectText mass;
    add(mass, node.mass, names::displacements);
    if (!mass.is_empty()) object.add("mass", mass.str());
    return object.str();
}

void add_if(ObjectText& object, std::string_view key, const MemberEnd& end)
{
    ObjectText inner;
    if (!end.release.is_empty()) inner.add("release", text_of(end.release));
    if (!end.springs.empty()) inner.add("spring", text_of(end.springs));
    if (!end.offset.empty()) inner.add("offset", list_of(end.offset));
    if (!inner.is_empty()) object.add(key, inner.str());
}

std::string text_of(const Member& member, const Model& model)
{
    const auto node = [&](NodeId id) { return quoted_json(model.nodes.at(id.index).id); };
    ObjectText object;
    object.add_text("id", member.id).add("nodes", json_list({node(member.nodes[0]), node(member.nodes[1])}));
    if (member.material) object.add_text("material", model.materials.at(member.material->index).id);
    if (member.section) object.add_text("section", model.sections.at(member.section->index).id);
    if (!member.depths.empty()) object.add("depths", list_of(member.depths));
    add_if(object, "start", member.start);
    add_if(object, "end", member.end);
    if (member.theory != BeamTheory::EulerBernoulli) object.add("theory", word(names::theories, member.theory));
    add_if(object, "inextensible", member.inextensible);
    add_if(object, "unshearable", member.unshearable);
    add_if(object, "rigid", member.rigid);
    add_if(object, "bar", member.bar);
    add_if(object, "tension_only", member.tension_only);
    add_if(object, "compression_only", member.compression_only);
    if (member.foundation) object.add("foundation", ObjectText().add("y", *member.foundation).str());
    if (!member.up.empty()) object.add("up", list_of(member.up));
    return object.str();
}

void add_axes(ObjectText& object, LoadAxes axes)
{
    if (axes == LoadAxes::Local) object.add("axes", word(names::axes, axes));
}

void add(ObjectText& object, const DistributedLoad& load)
{
    object.add("kind", word(names::member_loads, 0));
    for (const DistributedLoad::Value& value : load.values) {
        const std::string start = json_text(value.start);
        object.add(names::line_loads[index(value.dof)], value.end ? json_list({start, json_text(*value.end)}) : start);
    }
    add_if(object, "from", load.from);
    add_if(object, "to", load.to);
    add_axes(object, load.axes);
    add_if(object, "projected", load.projected);
}

void add(ObjectText& object, const PointLoad& load)
{
    object.add("kind", word(names::member_loads, 1)).add("at", json_text(load.at));
    add(object, load.components, names::nodal_forces);
    add_axes(object, load.axes);
}

void add(ObjectText& object, const EndLoads& load)
{
    object.add("kind", word(names::member_loads, 2));
    add(object, load.start, names::nodal_forces, "start_");
    add(object, load.end, names::nodal_forces, "end_");
    add_axes(object, load.axes);
}

void add(ObjectText& object, const TemperatureLoad& load)
{
    object.add("kind", word(names::member_loads, 3)).add("top", load.top).add("bottom", load.bottom);
}

void add(ObjectText& object, const Misfit& load)
{
    object.add("kind", word(names::member_loads, 4)).add("elongation", load.elongation);
}

std::string text_of(const MemberLoad& load, const Model& model)
{
    ObjectText object;
    object.add_text("member", model.members.at(load.member.index).id);
    std::visit([&](const auto& kind) { add(object, kind); }, load.load);
    return object.str();
}

/// A load case on one line if it fits, else with a load a line.
std::string text_of(const LoadCase& load_case, const Model& model)
{
    ObjectText object;
    object.add_text("id", load_case.id);
    if (load_case.self_weight != 0.0) object.add("self_weight", json_text(load_case.self_weight));
    const auto node = [&](NodeId id) -> const std::string& { return model.nodes.at(id.index).id; };
    NamedLists lists{{"nodes", {}}, {"settlements", {}}, {"members", {}}};
    for (const NodeLoad& load : load_case.nodes) {
        ObjectText line;
        line.add_text("node", node(load.node));
        add(line, load.components, names::nodal_forces);
        lists[0].second.push_back(line.str());
    }
    for (const Settlement& settlement : load_case.settlements) {
        ObjectText line;
        line.add_text("node", node(settlement.node));
        add(line, settlement.components, names::displacements);
        lists[1].second.push_back(line.str());
    }
    for (const MemberLoad& load : load_case.members) lists[2].second.push_back(text_of(load, model));

    return with_lists(std::move(object), lists);
}

std::string text_of(const Combination& combination, const Model& model)
{
    return combination_text(combination, [&](CaseId id) { return model.case_name(id); });
}

std::string list_of(const std::vector<MemberId>& members, const Model& model)
{
    Lines names;
    for (const MemberId member : members) names.push_back(quoted_json(model.members.at(member.index).id));
    return json_list(names);
}

std::string text_of(const LoadPath& path, const Model& model)
{
    return ObjectText().add_text("id", path.id).add("members", list_of(path.members, model)).str();
}

std::string text_of(const LoadPathReference& path, const Model& model)
{
    if (const auto* id = std::get_if<PathId>(&path)) return quoted_json(model.moving_loads.paths.at(id->index).id);
    return list_of(std::get<std::vector<MemberId>>(path), model);
}

void add(ObjectText& object, const MovingEffect& effect, const Model& model)
{
    object.add("quantity", word(names::quantities, effect.quantity));
    if (effect.node) object.add_text("node", model.nodes.at(effect.node->index).id);
    if (effect.member) object.add_text("member", model.members.at(effect.member->index).id);
    if (effect.component) object.add_text("component", name(*effect.component, model.analysis));
    if (effect.dof) {
        const bool is_force = effect.quantity == ExpectedQuantity::Reaction;
        object.add_text("component", is_force ? force_name(*effect.dof) : name(*effect.dof));
    }
    add_if(object, "at", effect.at);
    if (effect.side) object.add("side", word(names::sides, *effect.side));
}

void add_unit_load(ObjectText& object, const std::vector<Component>& load)
{
    ObjectText inner;
    add(inner, load, names::nodal_forces);
    if (!inner.is_empty()) object.add("load", inner.str());
}

std::string text_of(const InfluenceLineDefinition& line, const Model& model)
{
    ObjectText object;
    object.add_text("id", line.id).add("path", text_of(line.path, model));
    add(object, line.effect, model);
    add_unit_load(object, line.load);
    return object.str();
}

std::string text_of(const ConcentratedForce& force)
{
    if (!force.for_others) return json_text(force.for_moments);
    return ObjectText().add("moment", force.for_moments).add("shear", *force.for_others).str();
}

void add_concentrated(ObjectText& object, const std::vector<ConcentratedForce>& forces)
{
    Lines texts;
    for (const ConcentratedForce& force : forces) texts.push_back(text_of(force));
    if (!texts.empty()) object.add("concentrated", json_list(texts));
}

void add_ranges(ObjectText& object, const std::vector<SpacingRange>& ranges)
{
    ObjectText inner;
    for (const SpacingRange& range : ranges)
        inner.add(std::to_string(range.spacing + 1), json_list({json_text(range.min), json_text(range.max)}));
    if (!inner.is_empty()) object.add("spacing_ranges", inner.str());
}

std::string text_of(const Train& train, const Model& model)
{
    ObjectText object;
    object.add_text("id", train.id).add("path", text_of(train.path, model));
    if (!train.axles.empty()) object.add("axles", list_of(train.axles));
    if (!train.spacings.empty()) object.add("spacings", list_of(train.spacings));
    add_ranges(object, train.spacing_ranges);
    add_if(object, "both_directions", train.both_directions);
    if (train.impact != 1.0) object.add("impact", json_text(train.impact));
    add_if(object, "uniform", train.uniform);
    if (train.uniform_extent != UniformExtent::Adverse)
        object.add("uniform_extent", word(names::uniform_extents, train.uniform_extent));
    add_if(object, "gap", train.gap);
    add_concentrated(object, train.concentrated);
    add_unit_load(object, train.load);
    return object.str();
}

std::string text_of(const MovingEnvelope& envelope, const Model& model)
{
    Lines trains;
    for (const TrainId train : envelope.trains)
        trains.push_back(quoted_json(model.moving_loads.trains.at(train.index).id));
    ObjectText object;
    object.add_text("id", envelope.id).add("trains", json_list(trains));
    if (envelope.with) object.add_text("with", model.case_name(*envelope.with));
    if (envelope.factor != 1.0) object.add("factor", json_text(envelope.factor));
    return object.str();
}

std::string text_of(const Expected& check, const Model& model)
{
    ObjectText object;
    if (check.load_case) object.add_text("case", model.case_name(*check.load_case));
    if (check.analysis != ExpectedAnalysis::Linear)
        object.add("analysis", word(names::expected_analyses, check.analysis));
    object.add("quantity", word(names::quantities, check.quantity));
    if (check.node) object.add_text("node", model.nodes.at(check.node->index).id);
    if (check.member) object.add_text("member", model.members.at(check.member->index).id);
    if (check.component) object.add_text("component", name(*check.component, model.analysis));
    if (check.dof) {
        const bool is_force = check.quantity == ExpectedQuantity::Reaction;
        object.add_text("component", is_force ? force_name(*check.dof) : name(*check.dof));
    }
    add_if(object, "at", check.at);
    if (check.side) object.add("side", word(names::sides, *check.side));
    if (check.extreme) object.add("which", word(names::extremes, *check.extreme));
    if (check.mode) object.add("which", std::to_string(*check.mode));
    object.add("value", check.value);
    if (check.rtol) object.add("rtol", json_text(*check.rtol));
    add_if(object, "atol", check.atol);
    if (!check.source.empty()) object.add_text("source", check.source);
    return object.str();
}

std::string pretty(const ExtraBlock& block)
{
    const JsonReading json = parse_json(block.json);
    if (!json.document) throw std::invalid_argument("write_model: block \"" + block.key + "\" does not hold JSON");
    return pretty_json(json.document->root(), 2, line_width);
}

} // namespace

std::string write_model(const Model& model)
{
    ModelText file;
    const auto alone = [](const auto& part) { return text_of(part); };
    const auto in_model = [&](const auto& part) { return text_of(part, model); };
    file.add("cremona", "1");
    file.add_text("title", model.title);
    file.add_text("notes", model.notes);
    file.add("analysis", word(names::analyses, model.analysis));
    file.add("units", text_of(model.units));
    if (model.mass) file.add("mass", word(names::masses, *model.mass));
    file.add_list_if("materials", model.materials, alone);
    file.add_list_if("sections", model.sections, alone);
    file.add_list("nodes", model.nodes, [&](const Node& node) { return text_of(node, model.analysis); });
    file.add_list("members", model.members, in_model);
    file.add_list_if("load_cases", model.load_cases, in_model);
    file.add_list_if("combinations", model.combinations, in_model);
    file.add_list_if("paths", model.moving_loads.paths, in_model);
    file.add_list_if("influence_lines", model.moving_loads.influence_lines, in_model);
    file.add_list_if("trains", model.moving_loads.trains, in_model);
    file.add_list_if("moving_envelopes", model.moving_loads.envelopes, in_model);
    for (const ExtraBlock& block : model.extra) file.add(block.key, pretty(block));
    file.add_list_if("expected", model.expected, in_model);
    return file.str();
}

} // namespace femoop
