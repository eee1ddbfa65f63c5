#include <utility>

#include "femoop/io/reader/model_reader.h"
#include "femoop/io/reader/names.h"

namespace femoop {

namespace {

constexpr Keys<13> expected_keys{{"quantity", "value", "case", "analysis", "node", "member", "component", "at", "side",
                                  "which", "rtol", "atol", "source"},
                                 2};

std::vector<std::string_view> component_names(AnalysisKind kind)
{
    std::vector<std::string_view> names;
    for (const MemberComponent component : all_member_components)
        if (!name(component, kind).empty()) names.push_back(name(component, kind));
    return names;
}

} // namespace

Expected ModelReader::expected(JsonValue value, const Place& place)
{
    const auto [quantity, number, load_case, analysis, node, member, component, at, side, which, rtol, atol,
                source] = reader_.fields(value, expected_keys, place);
    Expected check;
    const auto chosen = reader_.choice(quantity, names::quantities, place);
    if (chosen) check.quantity = static_cast<ExpectedQuantity>(*chosen);
    if (const auto kind = reader_.choice(analysis, names::expected_analyses, place))
        check.analysis = static_cast<ExpectedAnalysis>(*kind);
    if (load_case.is_present()) check.load_case = CaseId(reference(load_case, cases_, place));
    if (node.is_present()) check.node = NodeId(reference(node, nodes_, place));
    if (member.is_present()) check.member = MemberId(reference(member, members_, place));
    if (chosen) read_component(check, component, place);
    check.at = position(at, place);
    if (const auto chosen_side = reader_.choice(side, names::sides, place))
        check.side = static_cast<Side>(*chosen_side);
    if (chosen) read_which(check, which, place);
    check.value = no_number;
    if (chosen) check.value = reader_.quantity(number, dimension_of(check), place).value_or(no_number);
    if (chosen) check.atol = reader_.quantity(atol, dimension_of(check), place);
    check.rtol = reader_.number(rtol, place);
    check.source = reader_.text(source, place).value_or("");
    return check;
}

void ModelReader::read_component(Expected& check, JsonValue component, const Place& place)
{
    if (!component.is_present()) return;
    if (check.member) {
        const auto names = component_names(model.analysis);
        if (const auto chosen = reader_.choice(component, names, place))
            check.component = find_member_component(names[*chosen], model.analysis);
        return;
    }
    const bool is_force = check.quantity == ExpectedQuantity::Reaction;
    if (const auto chosen = reader_.choice(component, is_force ? names::nodal_forces : names::displacements, place))
        check.dof = all_dofs[*chosen];
}

void ModelReader::read_which(Expected& check, JsonValue which, const Place& place)
{
    if (!which.is_present()) return;
    if (which.is(JsonKind::String)) {
        if (const auto chosen = reader_.choice(which, names::extremes, place))
            check.extreme = static_cast<ExtremeKind>(*chosen);
        return;
    }
    constexpr double most_modes = 1e6;
    const auto mode = reader_.number(which, place);
    const bool is_count = mode && *mode >= 1.0 && *mode <= most_modes &&
                          *mode == static_cast<double>(static_cast<int>(*mode));
    if (is_count) check.mode = static_cast<int>(*mode);
    else if (mode) reader_.add({FaultKind::BadMode, {place.text("which"), compact_json(which)}});
}

} // namespace femoop
