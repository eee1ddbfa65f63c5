#include "apps/frame/influence/asked_line.h"

#include <algorithm>
#include <utility>

#include "femoop/geometry/member_geometry.h"
#include "femoop/methods/influence/load_components.h"
#include "femoop/methods/influence/usual_path.h"
#include "femoop/model/fault/fault.h"
#include "femoop/result/components.h"

namespace frame {

using femoop::Dof;
using femoop::ExpectedQuantity;
using femoop::MemberComponent;
using femoop::Model;
using femoop::MovingEffect;

namespace {

bool has(const Model& model, MemberComponent component)
{
    const std::vector<MemberComponent> all = femoop::section_force_components(model.analysis);
    return std::ranges::find(all, component) != all.end();
}

MemberComponent foremost_component(const Model& model)
{
    return femoop::is_truss(model.analysis) ? MemberComponent::N : MemberComponent::Mz;
}

Dof upright(const Model& model)
{
    return femoop::influence::components_of(femoop::influence::unit_load(model.analysis, {})).front().dof;
}

} // namespace

void AskedLine::ask(const Model& model, const drawing::Cut& cut)
{
    const bool goes_on = !femoop::is_truss(model.analysis) && has(model, last_component_); // of a bar it is its force
    const MemberComponent component = goes_on ? last_component_ : foremost_component(model);
    asked_ = Asked{.member = model[cut.member].id, .x = cut.x, .component = component};
}

void AskedLine::ask(const Model& model, femoop::NodeId node)
{
    const Dof down = upright(model);
    asked_ = Asked{.node = model[node].id, .quantity = ExpectedQuantity::Displacement, .dof = down};
    const std::vector<MovingEffect> reactions = femoop::influence::reactions_at(model, node);
    if (reactions.empty()) return;
    asked_->quantity = ExpectedQuantity::Reaction;
    const bool bears = std::ranges::any_of(reactions, [&](const MovingEffect& one) { return one.dof == down; });
    asked_->dof = bears ? down : *reactions.front().dof;
}

void AskedLine::choose(const MovingEffect& effect)
{
    asked_->quantity = effect.quantity;
    asked_->component = effect.component;
    asked_->dof = effect.dof;
    if (effect.component && effect.quantity == ExpectedQuantity::SectionForce) last_component_ = *effect.component;
}

std::optional<MovingEffect> AskedLine::effect(const Model& model) const
{
    if (!asked_) return std::nullopt;
    MovingEffect effect{.quantity = asked_->quantity, .dof = asked_->dof, .component = asked_->component};
    if (!asked_->node.empty()) {
        effect.node = model.find_node(asked_->node);
        return effect.node ? std::optional(effect) : std::nullopt;
    }
    effect.member = model.find_member(asked_->member);
    if (!effect.member) return std::nullopt;
    const double length = femoop::geometry_of(model, model[*effect.member]).length;
    effect.at = femoop::Quantity(std::clamp(asked_->x, 0.0, length));
    return effect;
}

std::vector<MovingEffect> AskedLine::choices(const Model& model) const
{
    const std::optional<MovingEffect> now = effect(model);
    std::vector<MovingEffect> choices;
    if (!now) return choices;
    const auto add = [&](ExpectedQuantity quantity, std::optional<MemberComponent> component, std::optional<Dof> dof) {
        MovingEffect& one = choices.emplace_back(*now);
        one.quantity = quantity;
        one.component = component;
        one.dof = dof;
    };
    if (now->member) {
        for (const MemberComponent component : femoop::section_force_components(model.analysis))
            add(ExpectedQuantity::SectionForce, component, std::nullopt);
        return choices;
    }
    choices = femoop::influence::reactions_at(model, *now->node);
    if (!choices.empty()) return choices;
    for (const Dof dof : femoop::dof_list(model.analysis)) add(ExpectedQuantity::Displacement, std::nullopt, dof);
    return choices;
}

const drawing::InfluencePicture* AskedLine::picture(const Model& model, std::uint64_t generation,
                                                    const ui::Catalogue& tr) const
{
    const std::optional<MovingEffect> wanted = effect(model);
    if (!wanted || model.members.empty()) return nullptr;
    try {
        if (found_.generation != generation) {
            found_ = {.generation = generation};
            found_.analysis = std::make_shared<femoop::influence::InfluenceAnalysis>(model);
        }
        const bool is_here = found_.effect == wanted && found_.language == tr.language();
        if (found_.analysis && !is_here) find(model, *wanted, tr);
    } catch (const femoop::ModelError&) { // the problems say why the model cannot be solved
        found_.effect = wanted;
        found_.picture.reset();
    }
    return found_.picture.get();
}

void AskedLine::find(const Model& model, const MovingEffect& effect, const ui::Catalogue& tr) const
{
    found_.effect = effect;
    found_.language = tr.language();
    found_.picture.reset();
    const femoop::NodeVector load = femoop::influence::unit_load(model.analysis, {});
    const auto path = femoop::influence::lay_out(model, femoop::influence::usual_path(model, effect, load));
    drawing::InfluencePicture picture{.path = path, .load = load, .line = found_.analysis->line(path, load, effect)};
    picture.motion = found_.analysis->motion(effect);
    picture.sentences = {drawing::principle(effect, tr)};
    found_.picture = std::make_shared<const drawing::InfluencePicture>(std::move(picture));
}

} // namespace frame
