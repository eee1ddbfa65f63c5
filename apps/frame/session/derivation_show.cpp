#include "apps/frame/session/derivation_show.h"

#include <algorithm>

#include "apps/drawing/results/envelope_cases.h"
#include "apps/drawing/results/influence_picture.h"
#include "apps/drawing/sketch/counted_units.h"
#include "femoop/geometry/member_geometry.h"
#include "femoop/load/place_along.h"
#include "femoop/methods/force_method/force_steps.h"
#include "femoop/methods/influence/effect_name.h"
#include "femoop/methods/influence/usual_path.h"
#include "femoop/model/fault/fault.h"
#include "femoop/result/components.h"

namespace frame {

using femoop::ExpectedQuantity;
using femoop::MovingEffect;
using ui::translatable;

namespace {

std::vector<MovingEffect> numbers_of_node(const femoop::Model& model, femoop::NodeId node)
{
    std::vector<MovingEffect> numbers = femoop::influence::reactions_at(model, node);
    for (const femoop::Dof dof : femoop::dof_list(model.analysis))
        numbers.push_back({.quantity = ExpectedQuantity::Displacement, .node = node, .dof = dof});
    return numbers;
}

/// A bar of a truss has a transverse force and a moment only where it carries loads between its nodes.
bool carries_loads_across(const femoop::Model& model, femoop::MemberId member)
{
    return std::ranges::any_of(model.load_cases, [&](const femoop::LoadCase& one) {
        return one.self_weight != 0.0 ||
               std::ranges::find(one.members, member, &femoop::MemberLoad::member) != one.members.end();
    });
}

std::vector<MovingEffect> numbers_of_member(const femoop::Model& model, MovingEffect effect)
{
    std::vector<MovingEffect> numbers;
    const bool is_extreme = effect.quantity == ExpectedQuantity::Extreme;
    const auto add = [&](ExpectedQuantity quantity, const std::vector<femoop::MemberComponent>& components) {
        effect.quantity = is_extreme ? ExpectedQuantity::Extreme : quantity;
        for (const femoop::MemberComponent component : components) {
            effect.component = component;
            numbers.push_back(effect);
        }
    };
    const bool has_axial_force_alone = is_truss(model.analysis) && !carries_loads_across(model, *effect.member) &&
                                       effect.component == femoop::MemberComponent::N;
    add(ExpectedQuantity::SectionForce, has_axial_force_alone ? std::vector{femoop::MemberComponent::N}
                                                              : femoop::section_force_components(model.analysis));
    add(ExpectedQuantity::Displacement, femoop::local_displacement_components(model.analysis));
    return numbers;
}

/// Why what is shown of a session is not followed from the data to numbers.
std::optional<ui::Message> why_no_numbers(const Session& session)
{
    if (const auto reason = session.why_no_results()) return reason;
    if (session.model().n_cases() == 0) return translatable("The model has no load case.");
    return std::nullopt;
}

/// What stands on the influence line that is looked at; null where nothing does.
const drawing::StandingTrain* standing_on(const Session& session)
{
    return session.shown_line() != nullptr ? session.influence.standing() : nullptr;
}

/// The force method is of one case.
std::optional<ui::Message> why_no_states(const Session& session)
{
    if (auto reason = why_no_numbers(session)) return reason;
    if (!session.view.is_envelope) return std::nullopt;
    return translatable("An envelope has the numbers of several cases; choose one of them for the force method.");
}

ui::Message sentences(const std::vector<femoop::Fault>& faults, const ui::Catalogue& tr)
{
    std::string text;
    for (const femoop::Fault& fault : faults) text += (text.empty() ? "" : "; ") + femoop::message(fault, tr);
    return {text};
}

/// Which forces it is that were released, then how the structure moves: a support that was taken away is not to be added.
ui::Message sentences(const femoop::MechanismError& error, const ui::Catalogue& tr)
{
    std::string text = sentences(error.causes(), tr).sentence;
    for (const femoop::Mechanism& mechanism : error.mechanisms())
        text += (text.empty() ? "" : "; ") + femoop::without_remedy(femoop::message(mechanism.fault, tr));
    return {text};
}

femoop::force_method::ForceMethod solved(const Session& session, std::span<const MovingEffect> redundants)
{
    const femoop::Model model = solved_model(session.model(), session.solution());
    return femoop::force_method::solve(model, *session.solution().results, session.view.load_case, redundants);
}

/// The same number of a model whose lengths are so many times as large numbers.
MovingEffect scaled(MovingEffect effect, double length_factor)
{
    auto* const length = effect.at ? std::get_if<femoop::Quantity>(&*effect.at) : nullptr;
    if (length != nullptr && length_factor != 1.0) *length = femoop::Quantity(length->value() * length_factor);
    return effect;
}

std::vector<MovingEffect> scaled(std::span<const MovingEffect> effects, double length_factor)
{
    std::vector<MovingEffect> all;
    for (const MovingEffect& one : effects) all.push_back(scaled(one, length_factor));
    return all;
}

/// What the force method sums: moments, of trusses normal forces.
ui::Measure summed(femoop::AnalysisKind kind) { return is_truss(kind) ? ui::Measure::Force : ui::Measure::Moment; }

/// The same number of the model that results were kept of, where its member may have another length. Nothing where it has
/// no such part.
std::optional<MovingEffect> effect_kept(const femoop::Model& kept, const femoop::Model& now, const MovingEffect& effect)
{
    std::optional<MovingEffect> of_kept = effect_in(kept, NamedEffect(now, effect));
    if (!of_kept || !of_kept->at) return of_kept;
    const double length = femoop::geometry_of(now, now[*effect.member]).length;
    const double share = femoop::along(*effect.at, length) / length;
    of_kept->at = femoop::Quantity(share * femoop::geometry_of(kept, kept[*of_kept->member]).length);
    return of_kept;
}

/// The case of the results that were kept which what is shown is compared with.
std::optional<femoop::CaseId> kept_case(const Session& session)
{
    return session.reference ? session.reference->counterpart(session.model(), session.view.load_case) : std::nullopt;
}

} // namespace

std::optional<RefusedRelease> refused_release(const Session& session, std::span<const MovingEffect> redundants)
{
    if (auto reason = why_no_states(session)) return RefusedRelease{*reason};
    const std::string place = session.tr()("force method");
    const auto faults = femoop::force_method::check_redundants(session.model(), redundants, place);
    if (!faults.empty()) return RefusedRelease{sentences(faults, session.tr())};
    try {
        solved(session, redundants);
        return std::nullopt;
    } catch (const femoop::MechanismError& error) {
        return RefusedRelease{.reason = sentences(error, session.tr()),
                              .primary = femoop::force_method::primary_structure(session.model(), redundants).model,
                              .motions = error.mechanisms(),
                              .session = session.number(),
                              .generation = session.generation()};
    } catch (const femoop::ModelError& error) {
        return RefusedRelease{sentences(error.faults(), session.tr())};
    }
}

std::vector<MovingEffect> numbers_beside(const femoop::Model& model, const MovingEffect& effect)
{
    std::vector<MovingEffect> numbers = effect.member ? numbers_of_member(model, effect)
                                                      : numbers_of_node(model, *effect.node);
    if (is_resultant(effect)) numbers.insert(numbers.begin(), effect);
    return numbers;
}

std::optional<femoop::CaseId> DerivationShow::asked_case(const femoop::Model& model) const
{
    return asked_case_ ? model.find_case(*asked_case_) : std::nullopt;
}

PointedNumber DerivationShow::beside(const femoop::Model& model, const MovingEffect& effect) const
{
    return {.effect = effect, .of = asked_case(model), .compared = compared_};
}

void DerivationShow::ask(const Session& session, const PointedNumber& number)
{
    clear();
    if (number.of) asked_case_ = session.model().case_name(*number.of);
    asked_ = NamedEffect(session.model(), number.effect);
    compared_ = number.compared;
    begin(session);
}

void DerivationShow::ask_standing(const Session& session)
{
    clear();
    is_of_standing_ = true;
    asked_ = NamedEffect(session.model(), *session.influence.effect(session.model()));
    begin(session);
}

void DerivationShow::ask_force_method(const Session& session, std::span<const MovingEffect> redundants)
{
    clear();
    redundants_.emplace();
    for (const MovingEffect& one : redundants) redundants_->emplace_back(session.model(), one);
    begin(session);
}

void DerivationShow::begin(const Session& session)
{
    session_ = session.number();
    follow(session);
}

void DerivationShow::clear() { *this = DerivationShow(); }

std::optional<ui::Message> DerivationShow::why_not_derive(const Session& session)
{
    if (!is_asked()) return translatable("Point at a number of the results and press W.");
    if (session_ != session.number()) return translatable("The number that is explained belongs to another tab.");
    if (redundants_) return why_no_states(session);
    if (compared_ != Compared::Now && !kept_case(session))
        return translatable("What this number was compared with is gone.");
    if (!is_of_standing_) return why_no_numbers(session);
    if (standing_on(session) != nullptr) return std::nullopt;
    return translatable("The load is gone from the influence line; point at an ordinate and press W.");
}

DerivationShow::MadeFor DerivationShow::state_of(const Session& session) const
{
    std::optional<Standing> standing;
    if (const auto* const load = is_of_standing_ ? standing_on(session) : nullptr)
        standing = {load->name, load->placing.position, load->placing.reversed};
    return {session.number(),
            session.generation(),
            session.view.load_case.index,
            session.view.is_envelope,
            session.hidden.has_value(),
            standing,
            ChosenUnits{session.view.units, session.view.unit_choices},
            session.reference};
}

void DerivationShow::follow(const Session& session)
{
    if (is_at(session)) return;
    made_for_ = state_of(session);
    derivation_.reset();
    derived_of_.reset();
    is_of_kept_model_ = false;
    length_factor_ = 1.0;
    force_method_.reset();
    choices_.clear();
    why_none_ = why_not_derive(session);
    if (!is_asked() || session_ != session.number()) return;
    try {
        if (redundants_) derive_force_method(session);
        else derive_number(session);
    } catch (const femoop::MechanismError& error) {
        why_none_ = sentences(error, session.tr());
    } catch (const femoop::ModelError& error) { // what can move once something is taken out
        why_none_ = sentences(error.faults(), session.tr());
    }
    if (n_steps() > 0) go_to(step_); // else it waits for the steps to come back
}

DerivationShow::Solved DerivationShow::solved_of(const Session& session, ui::Measure result)
{
    derived_of_.reset();
    const femoop::Model solved = solved_model(session.model(), session.solution());
    const femoop::Model& model = counted(session, solved, result);
    return {model, model.units == solved.units ? *session.solution().results : femoop::analyse(model)};
}

const femoop::Model& DerivationShow::counted(const Session& session, const femoop::Model& model, ui::Measure result)
{
    const drawing::CountedUnits units = drawing::counted_units(model, session.view, result);
    if (units.units == model.units) return model;
    length_factor_ = units.length;
    return derived_of_.emplace(drawing::counted_in(units, model));
}

void DerivationShow::derive_number(const Session& session)
{
    const auto effect = effect_in(session.model(), *asked_);
    if (effect) choices_ = numbers_beside(session.model(), *effect);
    is_lost_ = !effect || std::ranges::find(choices_, *effect) == choices_.end();
    if (is_lost_ || why_none_) return;
    if (is_of_standing_) derive_standing(session, *effect);
    else if (compared_ != Compared::Now) derive_compared(session, *effect);
    else derive_of_cases(session, *effect);
}

void DerivationShow::derive_standing(const Session& session, const MovingEffect& effect)
{
    derived_of_ = session.influence.loaded();
    const femoop::Model loaded = *derived_of_;
    const femoop::Model& model = counted(session, loaded, drawing::measure_of(effect));
    derivation_ = femoop::derivation::derive(model, femoop::analyse(model), femoop::CaseId(0),
                                             scaled(effect, length_factor_));
}

void DerivationShow::derive_of_cases(const Session& session, const MovingEffect& effect)
{
    const auto [model, results] = solved_of(session, drawing::measure_of(effect));
    const MovingEffect number = scaled(effect, length_factor_);
    const auto of = asked_case(model);
    if (of || !session.view.is_envelope)
        derivation_ = femoop::derivation::derive(model, results, of.value_or(session.view.load_case), number);
    else
        derivation_ = femoop::derivation::derive_governing(model, results, envelope_cases(model, session.view), number);
}

void DerivationShow::derive_compared(const Session& session, const MovingEffect& effect)
{
    using femoop::derivation::derive_difference;
    if (!effect_kept(session.reference->model, session.model(), effect)) {
        why_none_ = translatable("What this number is compared with has no such part.");
        return;
    }
    const bool is_of_now = session.reference->model == session.model();
    if (compared_ == Compared::Kept && !is_of_now) {
        derivation_ = derived_of_kept(session, effect);
        is_of_kept_model_ = true;
        return;
    }
    const femoop::CaseId now = session.view.load_case, kept = *kept_case(session);
    const double value_kept = is_of_now ? 0.0 : derived_of_kept(session, effect).value;
    const auto [model, results] = solved_of(session, drawing::measure_of(effect));
    const MovingEffect number = scaled(effect, length_factor_);
    if (!is_of_now) derivation_ = derive_difference(model, results, now, value_kept, number);
    else if (compared_ == Compared::Change) derivation_ = derive_difference(model, results, now, kept, number);
    else derivation_ = femoop::derivation::derive(model, results, kept, number);
}

femoop::derivation::Derivation DerivationShow::derived_of_kept(const Session& session, const MovingEffect& effect)
{
    const drawing::ReferenceResults& reference = *session.reference;
    const MovingEffect kept = *effect_kept(reference.model, session.model(), effect);
    derived_of_ = reference.model;
    const femoop::Model& model = counted(session, reference.model, drawing::measure_of(effect));
    const femoop::Results results = model.units == reference.model.units ? reference.results : femoop::analyse(model);
    return femoop::derivation::derive(model, results, *kept_case(session), scaled(kept, length_factor_));
}

void DerivationShow::derive_force_method(const Session& session)
{
    std::vector<MovingEffect> redundants;
    is_lost_ = false;
    for (const NamedEffect& one : *redundants_) {
        const auto effect = effect_in(session.model(), one);
        if (effect) redundants.push_back(*effect);
        else gone_ = one;
        is_lost_ = is_lost_ || !effect;
    }
    if (is_lost_ || why_none_) return;
    const auto faults = femoop::force_method::check_redundants(session.model(), redundants,
                                                               session.tr()("force method"));
    if (!faults.empty()) throw femoop::ModelError(faults);
    const auto [model, results] = solved_of(session, summed(session.model().analysis));
    force_method_ = std::make_shared<const femoop::force_method::ForceMethod>(
        femoop::force_method::solve(model, results, session.view.load_case, scaled(redundants, length_factor_)));
    derivation_ = femoop::force_method::steps(*force_method_, model);
}

std::vector<MovingEffect> DerivationShow::redundants() const
{
    return force_method_ ? scaled(force_method_->redundants, 1.0 / length_factor_) : std::vector<MovingEffect>();
}

ui::Message DerivationShow::lost() const
{
    const NamedEffect& gone = redundants_ ? *gone_ : *asked_;
    const bool is_of_member = !gone.member.empty();
    return {is_of_member ? translatable("The number that was explained is gone with member {part}.")
                         : translatable("The number that was explained is gone from node {part}."),
            {{"part", is_of_member ? gone.member : gone.node}}};
}

void DerivationShow::choose(std::size_t forward)
{
    if (choices_.empty()) return;
    const auto is_asked = [&](const MovingEffect& one) {
        const MovingEffect& asked = asked_->effect;
        return one.quantity == asked.quantity && one.component == asked.component && one.dof == asked.dof;
    };
    const auto now = static_cast<std::size_t>(std::ranges::find_if(choices_, is_asked) - choices_.begin());
    const MovingEffect& next = choices_[(now + forward) % choices_.size()];
    const bool was_extreme = asked_->effect.quantity == ExpectedQuantity::Extreme && derivation_;
    if (was_extreme) { // the others are those at its place, not extremes elsewhere
        asked_->effect.at = scaled(derivation_->effect, 1.0 / length_factor_).at;
        asked_->effect.side = derivation_->effect.side;
    }
    asked_->effect.quantity = !was_extreme                       ? next.quantity
                              : is_displacement(*next.component) ? ExpectedQuantity::Displacement
                                                                 : ExpectedQuantity::SectionForce;
    asked_->effect.component = next.component;
    asked_->effect.dof = next.dof;
    made_for_.reset();
}

void DerivationShow::choose_next() { choose(1); }
void DerivationShow::choose_previous() { choose(choices_.size() - 1); }

void DerivationShow::go_to(std::size_t step) { step_ = n_steps() == 0 ? 0 : std::min(step, n_steps() - 1); }

} // namespace frame
