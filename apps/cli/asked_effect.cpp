#include "apps/cli/asked_effect.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

#include "apps/cli/argument.h"
#include "femoop/geometry/node_position.h"
#include "femoop/geometry/path_walk.h"
#include "femoop/io/influence/influence_block.h"
#include "femoop/model/check/check.h"
#include "femoop/model/fault/errors_among.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/quantity_parser.h"
#include "femoop/result/components.h"

namespace cli {

namespace {

using femoop::Fault;
using femoop::FaultKind;
using femoop::Model;

using Takes = AskedEffect::Takes;

std::vector<std::string> names_of_member_components(femoop::AnalysisKind kind, Takes takes)
{
    std::vector<std::string> names;
    for (const femoop::MemberComponent component : femoop::all_member_components) {
        const bool is_taken = takes != (is_displacement(component) ? Takes::Forces : Takes::Displacements);
        const std::string_view name = femoop::name(component, kind);
        if (is_taken && !name.empty()) names.emplace_back(name);
    }
    return names;
}

constexpr std::string_view resultant = "R";

bool has_resultants(femoop::AnalysisKind kind)
{
    return dofs(kind).contains(femoop::Dof::ux) && !dofs(kind).contains(femoop::Dof::uz);
}

std::vector<std::string> node_components(femoop::AnalysisKind kind, Takes takes)
{
    std::vector<std::string> names;
    if (takes != Takes::Displacements)
        for (const femoop::Dof dof : femoop::all_dofs)
            if (dofs(kind).contains(dof)) names.emplace_back(force_name(dof));
    if (takes == Takes::Numbers && has_resultants(kind)) names.emplace_back(resultant);
    if (takes != Takes::Forces)
        for (const femoop::Dof dof : femoop::all_dofs)
            if (dofs(kind).contains(dof)) names.emplace_back(femoop::name(dof));
    return names;
}

std::optional<double> number_in(std::string_view text)
{
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool is_number = error == std::errc() && end == text.data() + text.size() && std::isfinite(value);
    return is_number ? std::optional(value) : std::nullopt;
}

femoop::Position position_named(const std::string& option, const std::string& found, const Model& model)
{
    std::string_view text = found;
    if (!text.empty() && text.back() == '%') {
        text.remove_suffix(1);
        if (const auto share = number_in(text)) return femoop::Percent{*share};
        throw femoop::ModelError({Fault{FaultKind::BadPercentage, {option, found}}});
    }
    return length_named(option, found, model);
}

} // namespace

void AskedEffect::declare(OptionParser& options, const ui::Catalogue& tr)
{
    options.add_option("--member", member_, tr("ask for a section force or a displacement of this member"))
        .option_text("M");
    options.add_option("--at", at_, tr("where on it: a length from its first node, or a part of its length like 50%"))
        .option_text("X");
    options.add_option("--node", node_, tr("ask for a reaction or a displacement of this node")).option_text("N");
    options
        .add_option("--component", component_,
                    tr("of a member N V M u v (in space N Vy Vz T My Mz u v w), of a node fx fy fz mx my mz for its "
                       "reaction, ux uy uz rx ry rz for its displacement"))
        .option_text("C");
}

std::string AskedEffect::named(std::string_view key) const
{
    return (within_.empty() ? "--" : within_ + " ") + std::string(key);
}

/// An id may hold commas: what follows one is a part of its own where it begins with a key.
void AskedEffect::set(std::string_view option, std::string_view text, const ui::Catalogue& tr, Takes takes)
{
    takes_ = takes;
    within_ = option;
    const std::array<std::pair<std::string_view, std::optional<std::string>*>, 4> keys{
        {{"member", &member_}, {"node", &node_}, {"component", &component_}, {"at", &at_}}};
    const auto key_of = [&](std::string_view part) {
        return std::ranges::find_if(keys, [&](const auto& key) {
            return part.starts_with(key.first) && part.substr(key.first.size()).starts_with('=');
        });
    };
    std::optional<std::string>* last = nullptr;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string_view part = text.substr(begin, end - begin);
        if (const auto* key = key_of(part); key != keys.end()) {
            last = key->second;
            if (*last)
                throw UsageError(tr("{option}: {key} is given twice; keep one. A name with \",{key}=\" in it cannot be "
                                    "asked for like this: what follows that comma is read as a part of its own; "
                                    "rename it",
                                    {{"option", option}, {"key", key->first}}));
            *last = part.substr(key->first.size() + 1);
        } else if (last != nullptr) {
            **last += "," + std::string(part);
        } else {
            throw UsageError(
                tr("{option}: \"{found}\" asks for nothing; write it like member=BC,at=50%,component=M, or "
                   "node=B,component=ux",
                   {{"option", option}, {"found", femoop::printable(text)}}));
        }
        begin = end + 1;
    }
}

std::string AskedEffect::option() const { return member_ ? named("member") : node_ ? named("node") : "--path"; }

std::string AskedEffect::text() const
{
    return member_.value_or("") + node_.value_or("") + " " + component_.value_or("") + (at_ ? " " + *at_ : "");
}

void AskedEffect::require_sensible(const ui::Catalogue& tr, Place place) const
{
    if (!is_asked()) return;
    if (member_ && node_) throw ask_for_different_things(named("member"), named("node"), tr);
    const auto require = [&](bool is_there, const std::string& option, const std::string& missing) {
        if (!is_there) throw needs_too(option, missing, tr);
    };
    if (at_) require(member_.has_value(), named("at"), named("member"));
    if (component_) require(member_ || node_, named("component"), named("member") + ", " + named("node"));
    require(component_.has_value(), option(), named("component"));
    if (member_ && place == Place::Needed) require(at_.has_value(), named("member"), named("at"));
}

femoop::Position AskedEffect::place(const Model& model) const { return position_named(named("at"), *at_, model); }

femoop::MovingEffect AskedEffect::effect(const Model& model, const ui::Catalogue& tr) const
{
    femoop::MovingEffect effect;
    if (member_) {
        effect.member = model.find_member(*member_);
        if (!effect.member) throw unknown_choice(named("member"), *member_, ids_of(model.members), tr);
        effect.component = femoop::find_member_component(*component_, model.analysis);
        if (!effect.component)
            throw unknown_choice(named("component"), *component_, names_of_member_components(model.analysis, takes_),
                                 tr);
        if (at_) effect.at = place(model);
        effect.quantity = is_displacement(*effect.component) ? femoop::ExpectedQuantity::Displacement
                                                             : femoop::ExpectedQuantity::SectionForce;
        if (!at_) effect.quantity = femoop::ExpectedQuantity::Extreme;
        return effect;
    }
    effect.node = model.find_node(*node_);
    if (!effect.node) throw unknown_choice(named("node"), *node_, ids_of(model.nodes), tr);
    if (takes_ == Takes::Numbers && component_ == resultant && has_resultants(model.analysis)) {
        effect.quantity = femoop::ExpectedQuantity::Reaction;
        return effect;
    }
    const std::vector<std::string> known = node_components(model.analysis, Takes::Anything);
    if (std::ranges::find(known, *component_) == known.end())
        throw unknown_choice(named("component"), *component_, node_components(model.analysis, takes_), tr);
    const auto force = femoop::find_force_dof(*component_);
    effect.quantity = force ? femoop::ExpectedQuantity::Reaction : femoop::ExpectedQuantity::Displacement;
    effect.dof = force ? force : femoop::find_dof(*component_);
    return effect;
}

femoop::MovingEffect AskedEffect::sound_effect(const Model& model, const ui::Catalogue& tr) const
{
    const femoop::MovingEffect effect = this->effect(model, tr);
    femoop::MovingEffect checked = effect;
    if (is_resultant(effect)) checked.dof = femoop::Dof::ux;
    auto errors = errors_among(check_effect(model, checked, {option(), std::nullopt}));
    if (!errors.empty()) throw femoop::ModelError(std::move(errors));
    return effect;
}

double place_named(std::string_view option, const std::string& text, double length, const Model& model)
{
    const femoop::Position place = position_named(std::string(option), text, model);
    if (const auto* percent = std::get_if<femoop::Percent>(&place)) return percent->value / 100.0 * length;
    return std::get<femoop::Quantity>(place);
}

femoop::Quantity length_named(std::string_view option, const std::string& text, const Model& model)
{
    if (const auto length = number_in(text)) return femoop::Quantity(*length);
    auto parsed = femoop::parse_quantity(text, femoop::dimension::length, model.units);
    if (const double* number = std::get_if<double>(&parsed)) return femoop::Quantity(*number, text);
    auto& fault = std::get<Fault>(parsed);
    fault.arguments.front() = option;
    throw femoop::ModelError({std::move(fault)});
}

std::vector<double> lengths_named(std::string_view option, const std::string& text, std::size_t wanted,
                                  const Model& model, const ui::Catalogue& tr)
{
    std::vector<double> lengths;
    for (const std::string& part : comma_list(text)) lengths.push_back(length_named(option, part, model));
    if (lengths.size() == wanted) return lengths;
    throw UsageError(tr("{option}: found {found}; wanted {count} lengths with commas between them",
                        {{"option", option}, {"found", femoop::printable(text)}, {"count", std::to_string(wanted)}}));
}

void require_near(std::string_view option, const std::string& found, std::span<const double> lengths,
                  const Model& model, const ui::Catalogue& tr)
{
    constexpr double times = 1e6;
    double size = 0.0;
    for (std::size_t i = 0; i < model.nodes.size(); ++i)
        size = std::max(size, position_of(model, femoop::NodeId(i)).cwiseAbs().maxCoeff());
    const bool is_near = std::ranges::all_of(lengths, [&](double one) { return std::abs(one) <= times * size; });
    if (is_near) return;
    throw UsageError(
        tr("{option}: found {found}; wanted lengths up to {most}, a million times the farthest node; give "
           "a nearer place",
           {{"option", option},
            {"found", femoop::printable(found)},
            {"most", femoop::localized(quantity_text(times * size, femoop::dimension::length, model.units), tr)}}));
}

femoop::LoadPathReference path_named(const Model& model, const std::string& name, const ui::Catalogue& tr)
{
    const auto& paths = model.moving_loads.paths;
    const auto path = std::ranges::find(paths, name, &femoop::LoadPath::id);
    if (path != paths.end()) return femoop::PathId(static_cast<std::size_t>(path - paths.begin()));
    std::vector<femoop::MemberId> members;
    for (const std::string& part : comma_list(name)) {
        const auto member = model.find_member(part);
        if (member) members.push_back(*member);
        if (member) continue;
        if (std::ranges::find(paths, part, &femoop::LoadPath::id) != paths.end())
            throw UsageError(
                tr("--path: \"{path}\" is a path of the file and stands alone; name it alone, or members instead",
                   {{"path", part}}));
        std::vector<std::string> known = ids_of(model.members);
        if (part == name) std::ranges::move(ids_of(paths), std::back_inserter(known));
        throw unknown_choice("--path", part, known, tr);
    }
    if (auto fault = why_no_path(model, members, "--path")) throw femoop::ModelError({std::move(*fault)});
    return members;
}

femoop::LoadPathReference only_path(const Model& model)
{
    if (model.moving_loads.paths.size() == 1) return femoop::PathId(0);
    const auto block = femoop::influence::block_of(model);
    if (model.moving_loads.paths.empty() && block && !block->lines.empty()) return block->lines.front().line.path;
    throw femoop::ModelError({Fault{FaultKind::PathMissing, {"--path"}}});
}

} // namespace cli
