#include "apps/cli/asked_effect.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "apps/cli/argument.h"
#include "femoop/model/check/check.h"
#include "femoop/model/quantity/quantity_parser.h"
#include "femoop/result/components.h"

namespace cli {

namespace {

using femoop::ExpectedQuantity;
using femoop::Model;
using femoop::MovingEffect;

template <class Part>
std::size_t index_of(const std::vector<Part>& parts, std::string_view option, const std::string& name,
                     const ui::Catalogue& tr)
{
    std::vector<std::string> names;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i].id == name) return i;
        names.push_back(parts[i].id);
    }
    throw unknown_choice(option, name, names, tr);
}

/// "50%", a length in the file's unit, or one with its own.
femoop::Position position(const std::string& text, const Model& model, const ui::Catalogue& tr)
{
    const bool is_percentage = !text.empty() && text.back() == '%';
    const std::string digits = is_percentage ? text.substr(0, text.size() - 1) : text;
    double number = 0.0;
    const char* const end = digits.data() + digits.size();
    const auto read = std::from_chars(digits.data(), end, number);
    const bool is_number = read.ec == std::errc() && read.ptr == end && !digits.empty();
    if (is_number && is_percentage) return femoop::Percent{number};
    if (is_number) return femoop::Quantity(number);
    const auto quantity = femoop::parse_quantity(text, femoop::dimension::length, model.units);
    if (const double* const length = std::get_if<double>(&quantity)) return femoop::Quantity(*length, text);
    throw UsageError(tr("{option}: found \"{found}\", wanted a length or a percentage",
                        {{"option", "--at"}, {"found", text}}));
}

std::vector<std::string> names_of(const std::vector<femoop::MemberComponent>& components, const Model& model)
{
    std::vector<std::string> names;
    for (const femoop::MemberComponent component : components)
        names.emplace_back(femoop::name(component, model.analysis));
    return names;
}

void require_sound(const Model& model, const MovingEffect& effect)
{
    std::vector<femoop::Fault> faults = femoop::check_effect(model, effect, {"--component", std::nullopt});
    std::erase_if(faults, [](const auto& fault) { return femoop::severity(fault.kind) != femoop::Severity::Error; });
    if (!faults.empty()) throw femoop::ModelError(std::move(faults));
}

} // namespace

void AskedEffect::declare(CLI::App& app, const ui::Catalogue& tr)
{
    app.add_option("--member", member, tr("one effect alone: of this member"))->option_text("M");
    app.add_option("--at", at, tr("at this place along the member: a length, or a percentage as 50%"))
        ->option_text("X");
    app.add_option("--node", node, tr("one effect alone: of this node"))->option_text("N");
    app.add_option("--component", component,
                   tr("its component: N V M .. u v of a member; of a node a reaction (fx ..) or a displacement (ux ..)"))
        ->option_text("C");
}

MovingEffect AskedEffect::effect(const Model& model, const ui::Catalogue& tr) const
{
    if (member && node)
        throw UsageError(
            tr("{a} and {b} contradict one another; give one of them", {{"a", "--member"}, {"b", "--node"}}));
    if (!member && !node) throw UsageError(tr("which member or node? add --member M or --node N"));
    if (!component) throw UsageError(tr("which component? add --component C"));
    MovingEffect asked = member ? of_member(model, tr) : of_node(model, tr);
    require_sound(model, asked);
    return asked;
}

MovingEffect AskedEffect::of_member(const Model& model, const ui::Catalogue& tr) const
{
    MovingEffect asked;
    asked.member = femoop::MemberId(index_of(model.members, "--member", *member, tr));
    asked.component = femoop::find_member_component(*component, model.analysis);
    if (!asked.component)
        throw unknown_choice("--component", *component, names_of(femoop::member_components(model.analysis), model), tr);
    const bool is_displacement = femoop::is_displacement(*asked.component);
    if (at) asked.at = position(*at, model, tr);
    asked.quantity = is_displacement ? ExpectedQuantity::Displacement : ExpectedQuantity::SectionForce;
    if (!at) asked.quantity = ExpectedQuantity::Extreme;
    return asked;
}

MovingEffect AskedEffect::of_node(const Model& model, const ui::Catalogue& tr) const
{
    if (at)
        throw UsageError(tr("{a} and {b} contradict one another; give one of them", {{"a", "--at"}, {"b", "--node"}}));
    MovingEffect asked;
    asked.node = femoop::NodeId(index_of(model.nodes, "--node", *node, tr));
    asked.dof = femoop::find_force_dof(*component);
    asked.quantity = asked.dof ? ExpectedQuantity::Reaction : ExpectedQuantity::Displacement;
    if (!asked.dof) asked.dof = femoop::find_dof(*component);
    if (asked.dof) return asked;
    std::vector<std::string> names;
    for (const femoop::Dof dof : femoop::dof_list(model.analysis)) {
        names.emplace_back(femoop::force_name(dof));
        names.emplace_back(femoop::name(dof));
    }
    throw unknown_choice("--component", *component, names, tr);
}

} // namespace cli
