#include <string_view>
#include <utility>

#include "femoop/model/check/checker.h"

namespace femoop {

namespace {

bool is_modal(const Expected& check) { return check.analysis == ExpectedAnalysis::Modal; }

std::string_view name(ExpectedQuantity quantity)
{
    switch (quantity) {
    case ExpectedQuantity::Displacement: return "displacement";
    case ExpectedQuantity::Reaction: return "reaction";
    case ExpectedQuantity::SectionForce: return "section_force";
    case ExpectedQuantity::Extreme: return "extreme";
    case ExpectedQuantity::LoadFactor: return "load_factor";
    case ExpectedQuantity::Frequency: return "frequency";
    case ExpectedQuantity::CollapseFactor: break;
    }
    return "collapse_factor";
}

/// The keys that a check of this quantity cannot do without, as far as they are missing.
std::vector<std::string_view> missing_keys(const Expected& check)
{
    std::vector<std::string_view> missing;
    const auto need = [&](bool is_there, std::string_view key) {
        if (!is_there) missing.push_back(key);
    };
    const bool has_component = check.dof || check.component;
    switch (check.quantity) {
    case ExpectedQuantity::Displacement:
        need(check.node || check.member, "node");
        need(has_component, "component");
        if (check.member) need(check.at.has_value(), "at");
        break;
    case ExpectedQuantity::Reaction:
        need(check.node.has_value(), "node");
        need(has_component, "component");
        break;
    case ExpectedQuantity::SectionForce:
        need(check.member.has_value(), "member");
        need(has_component, "component");
        need(check.at.has_value(), "at");
        break;
    case ExpectedQuantity::Extreme:
        need(check.member.has_value(), "member");
        need(has_component, "component");
        need(check.extreme.has_value(), "which");
        break;
    case ExpectedQuantity::LoadFactor:
    case ExpectedQuantity::Frequency: need(check.mode.has_value(), "which"); break;
    case ExpectedQuantity::CollapseFactor: break;
    }
    return missing;
}

} // namespace

void Checker::check_expected()
{
    for (std::size_t i = 0; i < model_.expected.size(); ++i) {
        is_partial_ = flag(unreadable_.expected, i);
        check_expected(model_.expected[i], {"expected", i, {}});
    }
}

void Checker::check_expected(const Expected& check, const Entry& place)
{
    if (check.load_case) require_entry(place, "cases", check.load_case->index, model_.n_cases());
    if (!check.load_case && !is_modal(check) && model_.n_cases() != 1)
        add(FaultKind::ExpectedWithoutCase, place, {std::to_string(model_.n_cases())});
    check_asked(check, place);
    require_finite(place, "value", check.value);
    if (check.rtol) require_not_negative(place, "rtol", *check.rtol, dimension::none);
    if (check.atol) require_not_negative(place, "atol", *check.atol, dimension_of(check));
}

void Checker::check_asked(const Expected& check, const Entry& place)
{
    if (check.node) require_entry(place, "nodes", check.node->index, model_.nodes.size());
    if (check.member) require_entry(place, "members", check.member->index, model_.members.size());
    for (const std::string_view key : missing_keys(check))
        add(FaultKind::ExpectedKeyMissing, place, {std::string(name(check.quantity)), std::string(key)});
    if (check.node && check.member) add(FaultKind::ExpectedNodeAndMember, place, {});
    if (check.dof && !dofs(model_.analysis).contains(*check.dof)) {
        const bool is_force = check.quantity == ExpectedQuantity::Reaction;
        add(FaultKind::ExpectedDofLacking, place,
            {std::string(is_force ? force_name(*check.dof) : femoop::name(*check.dof)), analysis()});
    }
    const bool is_reaction = check.quantity == ExpectedQuantity::Reaction && check.node && is_readable(*check.node);
    if (is_reaction && !model_[*check.node].support)
        add(FaultKind::ExpectedReactionOfFreeNode, place, {model_[*check.node].id});
    if (check.at && check.member && is_readable(*check.member))
        check_position(*check.at, "at", model_[*check.member], place);
}

} // namespace femoop
