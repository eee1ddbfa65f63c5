#include "femoop/result/describe.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <variant>
#include <vector>

#include "femoop/model/quantity/dimension.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/six_digits.h"
#include "femoop/model/quantity/unit_signs.h"
#include "femoop/result/components.h"
#include "femoop/result/structure_words.h"

namespace femoop {

namespace {

constexpr double noise = 1.0e-9;             // of the largest of its kind
constexpr double rounding_of_size = 1.0e-15; // of the structure's size

std::string join(const std::vector<std::string>& parts, std::string_view separator)
{
    std::string text;
    for (const std::string& part : parts) text += (text.empty() ? "" : std::string(separator)) + part;
    return text;
}

/// Says the model's numbers with their units and its directions in words.
class Words {
public:
    Words(const Model& model, const Translator& tr) : model_(model), tr_(tr) {}

    std::string tr(std::string_view text) const { return tr_(text); }
    std::string number(double value) const { return six_digits(value, tr_); }
    std::string quantity(double value, Dimension dimension) const { return number(value) + " " + unit(dimension); }
    std::string length(double value) const { return quantity(value, dimension::length); }

    std::string point(const Node& node) const
    {
        std::vector<double> coordinates;
        for (std::size_t i = 0; i < n_coordinates(model_.analysis); ++i) coordinates.push_back(node.at[i]);
        return place_text(coordinates, tr_);
    }

    std::string unit(Dimension dimension) const { return printed_unit(dimension, model_.units); }

    /// Of a load along a degree of freedom. A moment per length is told as one, not as the force that it comes to.
    std::string load_unit(Dof dof, bool is_per_length) const
    {
        const std::string whole = unit(is_rotation(dof) ? dimension::moment : dimension::force);
        return is_per_length ? whole + "/" + unit(dimension::length) : whole;
    }

    /// "12 kN down": the size and where it points.
    std::string directed(Dof dof, double value, const std::string& unit) const
    {
        return number(std::abs(value)) + " " + unit + " " + direction(dof, value > 0.0);
    }

    std::string force(Dof dof, double value) const { return directed(dof, value, load_unit(dof, false)); }

    /// The same in a member's own axes.
    std::string local(Dof dof, double value, const std::string& unit) const
    {
        const std::string axis = std::string(name(dof)).substr(1);
        const std::string how = is_rotation(dof) ? tr("{0} about {1}{2}' of the member")
                                                 : tr("{0} along {1}{2}' of the member");
        return fill(how, {number(std::abs(value)) + " " + unit, value < 0.0 ? "-" : "+", axis});
    }

    std::string case_title(CaseId id) const
    {
        const bool is_case = id.index < model_.load_cases.size();
        return fill(is_case ? tr("Load case {0}") : tr("Combination {0}"), {model_.case_name(id)});
    }

private:
    std::string direction(Dof dof, bool is_positive) const
    {
        if (is_plane(model_.analysis) && dof == Dof::ux) return is_positive ? tr("to the right") : tr("to the left");
        if (dof == (is_plane(model_.analysis) ? Dof::uy : Dof::uz)) return is_positive ? tr("up") : tr("down");
        if (is_plane(model_.analysis) && dof == Dof::rz) return is_positive ? tr("counter-clockwise") : tr("clockwise");
        const std::string axis = (is_positive ? "+" : "-") + std::string(name(dof)).substr(1);
        return fill(is_rotation(dof) ? tr("about {0}") : tr("along {0}"), {axis});
    }

    const Model& model_;
    const Translator& tr_;
};

std::string support_text(const Model& model, const Support& support, const Words& words)
{
    std::vector<std::string> parts;
    switch (support.kind) {
    case SupportKind::Fixed: parts.push_back(words.tr("fixed")); break;
    case SupportKind::Pin: parts.push_back(words.tr("pinned")); break;
    case SupportKind::Roller: parts.push_back(words.tr("roller")); break;
    case SupportKind::Custom: break;
    }
    std::string held;
    const DofSet blocked = support.blocked(model.analysis);
    for (const Dof dof : all_dofs)
        if (blocked.contains(dof)) held += (held.empty() ? "" : ", ") + std::string(name(dof));
    if (!held.empty()) parts.push_back(fill(words.tr("holds {0}"), {held}));
    for (const Spring& spring : support.springs) {
        const Dimension dimension = is_rotation(spring.dof) ? dimension::moment_per_angle : dimension::force_per_length;
        parts.push_back(fill(words.tr("spring of {0} on {1}"),
                             {words.quantity(spring.stiffness, dimension), std::string(name(spring.dof))}));
    }
    if (support.angle.value() != 0.0)
        parts.push_back(fill(words.tr("turned by {0} degrees"), {words.number(support.angle)}));
    return join(parts, "; ");
}

std::string released(const MemberEnd& end)
{
    std::string names;
    for (const Dof dof : all_dofs)
        if (end.release.contains(dof)) names += (names.empty() ? "" : ", ") + std::string(name(dof));
    return names;
}

void add_end(std::vector<std::string>& parts, const MemberEnd& end, const std::string& node, const Words& words)
{
    if (!end.release.is_empty()) parts.push_back(fill(words.tr("released at {0}: {1}"), {node, released(end)}));
    if (!end.springs.empty()) parts.push_back(fill(words.tr("semi-rigid at {0}"), {node}));
    if (!end.offset.empty()) parts.push_back(fill(words.tr("rigid offset at {0}"), {node}));
}

double distance(const Model& model, const Member& member)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double d = model[member.nodes[1]].at[i] - model[member.nodes[0]].at[i];
        sum += d * d;
    }
    return std::sqrt(sum);
}

std::string member_text(const Model& model, const Member& member, const Words& words)
{
    const std::string& first = model[member.nodes[0]].id;
    const std::string& second = model[member.nodes[1]].id;
    std::vector<std::string> parts{fill(words.tr("{0} from {1} to {2}, {3} between the nodes"),
                                        {member.id, first, second, words.length(distance(model, member))})};
    if (member.section && member.material)
        parts.push_back(
            fill(words.tr("section {0}, material {1}"), {model[*member.section].id, model[*member.material].id}));
    if (member.depths.size() == 2)
        parts.push_back(fill(words.tr("tapered, {0} deep at {1} and {2} at {3}"),
                             {words.length(member.depths[0]), first, words.length(member.depths[1]), second}));
    if (member.rigid) parts.push_back(words.tr("rigid"));
    if (member.bar) parts.push_back(words.tr("bar: axial force only"));
    if (member.inextensible) parts.push_back(words.tr("inextensible"));
    if (member.unshearable) parts.push_back(words.tr("unshearable"));
    if (member.theory == BeamTheory::Timoshenko) parts.push_back(words.tr("with shear strain (Timoshenko)"));
    if (member.foundation)
        parts.push_back(
            fill(words.tr("on an elastic foundation of {0}"), {words.quantity(*member.foundation, dimension::stress)}));
    add_end(parts, member.start, first, words);
    add_end(parts, member.end, second, words);
    return join(parts, "; ");
}

std::string place(const Position& position, const Words& words)
{
    if (const auto* percent = std::get_if<Percent>(&position)) return words.number(percent->value) + "%";
    return words.length(std::get<Quantity>(position));
}

/// What one member load is, in words; one overload a kind.
class LoadWords {
public:
    LoadWords(const Words& words, LoadAxes axes) : words_(words), axes_(axes) {}

    std::string component(Dof dof, double value, bool is_per_length) const
    {
        const std::string unit = words_.load_unit(dof, is_per_length);
        return axes_ == LoadAxes::Local ? words_.local(dof, value, unit) : words_.directed(dof, value, unit);
    }

    std::string components(const std::vector<Component>& list) const
    {
        std::vector<std::string> parts;
        for (const Component& one : list) parts.push_back(component(one.dof, one.value, false));
        return join(parts, ", ");
    }

private:
    const Words& words_;
    LoadAxes axes_;
};

std::string load_text(const DistributedLoad& load, const Words& words)
{
    const LoadWords say(words, load.axes);
    std::vector<std::string> parts;
    for (const DistributedLoad::Value& value : load.values) {
        std::string text = say.component(value.dof, value.start, true);
        if (value.end) text = fill(words.tr("{0} changing to {1}"), {text, say.component(value.dof, *value.end, true)});
        parts.push_back(text);
    }
    std::string text = join(parts, ", ");
    if (load.from || load.to)
        text += " " + fill(words.tr("from {0} to {1}"), {load.from ? place(*load.from, words) : words.length(0.0),
                                                         load.to ? place(*load.to, words) : words.tr("its end")});
    else text += " " + words.tr("over its whole length");
    return load.projected ? text + " " + words.tr("(per projected length)") : text;
}

std::string load_text(const PointLoad& load, const Words& words)
{
    return fill(words.tr("{0} at {1}"),
                {LoadWords(words, load.axes).components(load.components), place(load.at, words)});
}

std::string load_text(const EndLoads& load, const Words& words)
{
    const LoadWords say(words, load.axes);
    std::vector<std::string> parts;
    if (!load.start.empty()) parts.push_back(fill(words.tr("{0} on its first end"), {say.components(load.start)}));
    if (!load.end.empty()) parts.push_back(fill(words.tr("{0} on its second end"), {say.components(load.end)}));
    return join(parts, ", ");
}

std::string load_text(const TemperatureLoad& load, const Words& words)
{
    return fill(words.tr("warmed by {0} K at its +y' side and {1} K at its -y' side"),
                {words.number(load.top), words.number(load.bottom)});
}

std::string load_text(const Misfit& load, const Words& words)
{
    return fill(load.elongation.value() < 0.0 ? words.tr("built {0} too short") : words.tr("built {0} too long"),
                {words.length(std::abs(load.elongation.value()))});
}

void add_node_loads(std::vector<std::string>& lines, const Model& model, const LoadCase& loads, const Words& words)
{
    for (const NodeLoad& load : loads.nodes) {
        std::vector<std::string> parts;
        for (const Component& component : load.components) parts.push_back(words.force(component.dof, component.value));
        lines.push_back(fill(words.tr("on node {0}: {1}"), {model[load.node].id, join(parts, ", ")}));
    }
    for (const Settlement& settlement : loads.settlements) {
        std::vector<std::string> parts;
        for (const Component& component : settlement.components) {
            const std::string unit = is_rotation(component.dof) ? "rad" : words.unit(dimension::length);
            parts.push_back(std::string(name(component.dof)) + " = " + words.number(component.value) + " " + unit);
        }
        lines.push_back(fill(words.tr("support {0} is moved: {1}"), {model[settlement.node].id, join(parts, ", ")}));
    }
}

std::vector<std::string> case_loads(const Model& model, const LoadCase& loads, const Words& words)
{
    std::vector<std::string> lines;
    if (loads.self_weight != 0.0)
        lines.push_back(fill(words.tr("self-weight times {0}"), {words.number(loads.self_weight)}));
    add_node_loads(lines, model, loads, words);
    for (const MemberLoad& load : loads.members) {
        const std::string what = std::visit([&](const auto& kind) { return load_text(kind, words); }, load.load);
        lines.push_back(fill(words.tr("on member {0}: {1}"), {model[load.member].id, what}));
    }
    if (lines.empty()) lines.push_back(words.tr("no load"));
    return lines;
}

void add_section(std::string& text, const std::string& title, const std::vector<std::string>& lines)
{
    if (lines.empty()) return;
    text += title + ".\n";
    for (const std::string& line : lines) text += "  " + line + ".\n";
}

void add_structure(std::string& text, const Model& model, const Words& words)
{
    std::vector<std::string> supports, hinges, members;
    for (const Node& node : model.nodes) {
        if (node.support)
            supports.push_back(fill(words.tr("node {0} at {1}: {2}"),
                                    {node.id, words.point(node), support_text(model, *node.support, words)}));
        if (node.hinge) hinges.push_back(node.id);
    }
    for (const Member& member : model.members) members.push_back(member_text(model, member, words));
    add_section(text, words.tr("Supports"), supports);
    if (!hinges.empty()) add_section(text, words.tr("Hinges"), {fill(words.tr("at {0}"), {join(hinges, ", ")})});
    add_section(text, words.tr("Members"), members);
}

/// The largest distance of a node from the first one.
double extent_of(const Model& model)
{
    double extent = 0.0;
    for (const Node& node : model.nodes) {
        const auto& first = model.nodes.front().at;
        extent = std::max(extent, std::hypot(node.at[0] - first[0], node.at[1] - first[1], node.at[2] - first[2]));
    }
    return extent;
}

std::string largest_displacement(const Model& model, const CaseResult& result, const Words& words)
{
    double largest = -1.0;
    NodeId where;
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        const NodeVector u = result.displacement(NodeId(i));
        const double size = std::hypot(u[0], u[1], u[2]);
        if (size > largest * (1.0 + noise)) {
            largest = size;
            where = NodeId(i);
        }
    }
    if (largest <= rounding_of_size * extent_of(model)) return words.tr("no node moves");
    const NodeVector u = result.displacement(where);
    std::vector<std::string> parts;
    for (const Dof dof : dof_list(model.analysis))
        if (!is_rotation(dof) && std::abs(u[index(dof)]) > noise * largest)
            parts.push_back(words.directed(dof, u[index(dof)], words.unit(dimension::length)));
    return fill(words.tr("node {0} moves most: {1}"), {model[where].id, join(parts, ", ")});
}

void add_reactions(std::vector<std::string>& lines, const Model& model, const CaseResult& result, const Words& words)
{
    double largest = 0.0;
    for (std::size_t i = 0; i < model.nodes.size(); ++i)
        if (result.is_supported(NodeId(i)))
            for (const double value : result.reaction(NodeId(i))) largest = std::max(largest, std::abs(value));
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        if (!result.is_supported(NodeId(i))) continue;
        const NodeVector reaction = result.reaction(NodeId(i));
        std::vector<std::string> parts;
        for (const Dof dof : dof_list(model.analysis))
            if (std::abs(reaction[index(dof)]) > noise * largest)
                parts.push_back(words.force(dof, reaction[index(dof)]));
        const std::string what = parts.empty() ? words.tr("nothing") : join(parts, ", ");
        lines.push_back(fill(words.tr("the support at {0} gives the structure {1}"), {model.nodes[i].id, what}));
    }
}

/// The extreme of one section force over all members.
struct Peak {
    double value = 0.0;
    double x = 0.0;
    MemberId member;
};

Peak peak(const Model& model, const CaseResult& result, MemberComponent component, ExtremeKind which)
{
    Peak peak;
    for (std::size_t i = 0; i < model.members.size(); ++i) {
        const Extremes own = result.curve(MemberId(i)).extremes(component);
        const Extreme& here = which == ExtremeKind::Max ? own.max : own.min;
        const double margin = noise * std::abs(peak.value);
        const bool is_beyond = which == ExtremeKind::Max ? here.value > peak.value + margin
                                                         : here.value < peak.value - margin;
        if (i == 0 || is_beyond) peak = {here.value, here.x, MemberId(i)};
    }
    return peak;
}

/// The largest displacement along the members, in the axes of the member where it is.
void add_largest_along_members(std::vector<std::string>& lines, const Model& model, const CaseResult& result,
                               const Words& words)
{
    Peak largest;
    MemberComponent component = MemberComponent::v;
    for (const MemberComponent one : local_displacement_components(model.analysis))
        for (const ExtremeKind which : {ExtremeKind::Max, ExtremeKind::Min}) {
            const Peak here = peak(model, result, one, which);
            if (std::abs(here.value) <= std::abs(largest.value) * (1.0 + noise)) continue;
            largest = here;
            component = one;
        }
    if (largest.value == 0.0) return;
    lines.push_back(fill(words.tr("the largest displacement along a member is {0} = {1}, in member {2} at x = {3}"),
                         {std::string(name(component, model.analysis)), words.length(largest.value),
                          model[largest.member].id, words.length(largest.x)}));
}

/// "M is largest with 12 kN·m in member BC at x = 3 m, smallest with ..."; a force that is the same everywhere is said
/// so.
std::string extreme_text(const Model& model, const CaseResult& result, MemberComponent component, double scale,
                         const Words& words)
{
    const Dimension dimension = is_moment(component) ? dimension::moment : dimension::force;
    const std::string what(name(component, model.analysis));
    const auto clean = [&](double value) { return std::abs(value) < noise * scale ? 0.0 : value; };
    const Peak max = peak(model, result, component, ExtremeKind::Max);
    const Peak min = peak(model, result, component, ExtremeKind::Min);
    if (clean(max.value) == 0.0 && clean(min.value) == 0.0) return fill(words.tr("{0} is zero everywhere"), {what});
    if (max.value - min.value < noise * scale)
        return fill(words.tr("{0} is {1} everywhere"), {what, words.quantity(max.value, dimension)});
    return fill(
        words.tr("{0} is largest with {1} in member {2} at x = {3}, smallest with {4} in member {5} at x = {6}"),
        {what, words.quantity(clean(max.value), dimension), model[max.member].id, words.length(max.x),
         words.quantity(clean(min.value), dimension), model[min.member].id, words.length(min.x)});
}

void add_extremes(std::vector<std::string>& lines, const Model& model, const CaseResult& result, const Words& words)
{
    if (model.members.empty()) return;
    double scale = 0.0;
    for (const MemberComponent component : section_force_components(model.analysis))
        for (const ExtremeKind which : {ExtremeKind::Max, ExtremeKind::Min})
            scale = std::max(scale, std::abs(peak(model, result, component, which).value));
    for (const MemberComponent component : section_force_components(model.analysis))
        lines.push_back(extreme_text(model, result, component, scale, words));
}

std::string indeterminacy_text(const Indeterminacy& degree, const Words& words)
{
    if (degree.has_foundation)
        return words.tr("The structure is statically indeterminate: members stand on a continuous foundation");
    if (degree.total() == 0) return words.tr("The structure is statically determinate");
    if (degree.internal < 0)
        return fill(words.tr("The structure is statically indeterminate to degree {0}"),
                    {std::to_string(degree.total())});
    return fill(words.tr("The structure is statically indeterminate to degree {0} (external {1}, internal {2})"),
                {std::to_string(degree.total()), std::to_string(degree.external), std::to_string(degree.internal)});
}

void add_results(std::string& text, const Model& model, const Results& results, std::span<const CaseId> cases,
                 const Words& words)
{
    if (!model.members.empty()) text += indeterminacy_text(results.indeterminacy(), words) + ".\n";
    for (const CaseId id : cases) {
        const CaseResult result = results[id];
        std::vector<std::string> lines{largest_displacement(model, result, words)};
        if (!model.members.empty()) add_largest_along_members(lines, model, result, words);
        add_reactions(lines, model, result, words);
        add_extremes(lines, model, result, words);
        add_section(text, words.tr("Results") + ": " + words.case_title(id), lines);
    }
}

std::string kind_sentence(AnalysisKind kind, const Words& words)
{
    switch (kind) {
    case AnalysisKind::Truss2d: return words.tr("A plane truss: {0}, {1}");
    case AnalysisKind::Frame2d: return words.tr("A plane frame: {0}, {1}");
    case AnalysisKind::Grillage: return words.tr("A grillage: {0}, {1}");
    case AnalysisKind::Truss3d: return words.tr("A space truss: {0}, {1}");
    case AnalysisKind::Frame3d: break;
    }
    return words.tr("A space frame: {0}, {1}");
}

std::string describe_model(const Model& model, const Words& words)
{
    std::string text = model.title.empty() ? std::string() : printable(model.title) + ".\n";
    text += fill(kind_sentence(model.analysis, words),
                 {counted(model.nodes.size(), words.tr("{0} node"), words.tr("{0} nodes")),
                  counted(model.members.size(), words.tr("{0} member"), words.tr("{0} members"))}) +
            ".\n";
    add_structure(text, model, words);
    for (std::size_t i = 0; i < model.load_cases.size(); ++i)
        add_section(text, words.case_title(CaseId(i)), case_loads(model, model.load_cases[i], words));
    return text;
}

} // namespace

std::string describe(const Model& model, const Results& results, std::span<const CaseId> cases, const Translator& tr)
{
    const Words words(model, tr);
    std::string text = describe_model(model, words);
    add_results(text, model, results, cases, words);
    return text;
}

std::string describe(const Model& model, const std::optional<Results>& results, const Translator& tr)
{
    if (!results) return describe_model(model, Words(model, tr));
    std::vector<CaseId> all;
    for (std::size_t i = 0; i < results->n_cases(); ++i) all.emplace_back(i);
    return describe(model, *results, all, tr);
}

} // namespace femoop
