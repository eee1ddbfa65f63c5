#include "apps/frame/influence/asked_line.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "apps/drawing/results/influence_words.h"
#include "apps/drawing/results/line_motion.h"
#include "apps/drawing/sketch/scene.h"
#include "apps/frame/document/fault/sentence.h"
#include "femoop/analysis/linear_static.h"
#include "femoop/geometry/member_geometry.h"
#include "femoop/methods/influence/load_components.h"
#include "femoop/methods/influence/train/standing_train.h"
#include "femoop/methods/influence/usual_path.h"
#include "femoop/model/fault/fault.h"
#include "femoop/result/components.h"

namespace frame {

using femoop::Dof;
using femoop::ExpectedQuantity;
using femoop::ExtremeKind;
using femoop::MemberComponent;
using femoop::Model;
using femoop::MovingEffect;
using femoop::influence::Stretch;

namespace {

ExpectedQuantity effect_quantity(MemberComponent component)
{
    return femoop::is_displacement(component) ? ExpectedQuantity::Displacement : ExpectedQuantity::SectionForce;
}

/// What a line can be of at a section; loads come onto the joints of a bar of a truss alone.
std::vector<MemberComponent> components_at_section(const Model& model)
{
    if (is_truss(model.analysis)) return {MemberComponent::N};
    return femoop::member_components(model.analysis);
}

bool has(const Model& model, MemberComponent component)
{
    const std::vector<MemberComponent> all = components_at_section(model);
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
    const MemberComponent component = has(model, last_component_) ? last_component_ : foremost_component(model);
    asked_ = NamedEffect(model, {.quantity = effect_quantity(component),
                                 .member = cut.member,
                                 .component = component,
                                 .at = femoop::Quantity(cut.x)});
    begin_trace();
}

void AskedLine::ask(const Model& model, const MovingEffect& effect, const AskedTrain& train)
{
    asked_ = NamedEffect(model, effect);
    if (effect.component) last_component_ = *effect.component;
    train_ = train;
}

void AskedLine::ask(const Model& model, femoop::NodeId node)
{
    const Dof down = upright(model);
    asked_ = NamedEffect(model, {.quantity = ExpectedQuantity::Displacement, .node = node, .dof = down});
    begin_trace();
    const std::vector<MovingEffect> reactions = femoop::influence::reactions_at(model, node);
    if (reactions.empty()) return;
    MovingEffect& asked = asked_->effect;
    asked.quantity = ExpectedQuantity::Reaction;
    const bool bears = std::ranges::any_of(reactions, [&](const MovingEffect& one) { return one.dof == down; });
    asked.dof = bears ? down : *reactions.front().dof;
}

void AskedLine::choose(const MovingEffect& effect)
{
    MovingEffect& asked = asked_->effect;
    asked.quantity = effect.quantity;
    asked.component = effect.component;
    asked.dof = effect.dof;
    if (effect.component) last_component_ = *effect.component;
}

std::optional<MovingEffect> AskedLine::effect(const Model& model) const
{
    return asked_ ? effect_in(model, *asked_) : std::nullopt;
}

std::vector<MovingEffect> AskedLine::choices(const Model& model) const
{
    const std::optional<MovingEffect> now = effect(model);
    std::vector<MovingEffect> choices;
    if (!now) return choices;
    if (now->member) {
        for (const MemberComponent component : components_at_section(model)) {
            MovingEffect& one = choices.emplace_back(*now);
            one.quantity = effect_quantity(component);
            one.component = component;
        }
        return choices;
    }
    choices = femoop::influence::reactions_at(model, *now->node);
    for (const Dof dof : femoop::dof_list(model.analysis)) {
        const MovingEffect moved{.quantity = ExpectedQuantity::Displacement, .node = now->node, .dof = dof};
        if (!femoop::influence::holding_support(model, moved) || moved == now) choices.push_back(moved);
    }
    return choices;
}

void AskedLine::clear()
{
    asked_.reset();
    kept_.clear();
    train_ = {};
}

void AskedLine::keep(const Model& model)
{
    const std::vector<MovingEffect> all = kept(model);
    if (std::ranges::find(all, *effect(model)) == all.end()) kept_.push_back(*asked_);
}

std::vector<MovingEffect> AskedLine::kept(const Model& model) const
{
    std::vector<MovingEffect> all;
    for (const NamedEffect& named : kept_)
        if (const auto effect = effect_in(model, named)) all.push_back(*effect);
    return all;
}

void AskedLine::drop(const Model& model, const MovingEffect& effect)
{
    std::erase_if(kept_, [&](const NamedEffect& named) { return effect_in(model, named) == effect; });
}

void AskedLine::choose_train(const std::string& name) { train_ = {.name = name, .beside = train_.beside}; }

void AskedLine::trace()
{
    train_ = {.is_unit_load = true, .beside = train_.beside};
    begin_trace();
}

void AskedLine::put_unit_load(double s)
{
    train_ = {.is_unit_load = true, .place = AskedTrain::Place{.position = s}, .beside = train_.beside};
    traced_to_ = std::numeric_limits<double>::infinity();
}

// The line of another place is traced from its beginning; one of another effect there as far as the load has come.
void AskedLine::begin_trace()
{
    if (!train_.is_unit_load) return;
    traced_to_ = 0.0;
    train_.place = AskedTrain::Place{};
}

void AskedLine::seek(femoop::ExtremeKind kind)
{
    train_.kind = kind;
    train_.place.reset();
}

void AskedLine::put_train(const AskedTrain::Place& place)
{
    const Stretch along = positions(place.reversed);
    train_.place = {std::clamp(place.position, along.from, along.to), place.reversed};
}

std::optional<AskedTrain::Place> AskedLine::worst_place() const
{
    const femoop::influence::Placing& worst = worst_placing();
    if (!worst.position) return std::nullopt;
    return AskedTrain::Place{*worst.position, worst.reversed};
}

bool AskedLine::stands_at(const AskedTrain::Place& place) const
{
    const femoop::influence::Placing& placing = found_.standing->placing;
    constexpr double near = 1e-9; // of the path
    return placing.position && placing.reversed == place.reversed &&
           std::abs(*placing.position - place.position) <= near * found_.picture->path.length();
}

double AskedLine::nearest_on_path(const drawing::Projection& projection, ui::Point at) const
{
    const std::vector<femoop::influence::PathMember>& path = found_.picture->path.members;
    double nearest = 0.0, least = std::numeric_limits<double>::infinity();
    for (const femoop::influence::PathMember& on : path) {
        const auto [start, end] = femoop::ends_of(*found_.model, (*found_.model)[on.member]);
        const double length = (end - start).norm();
        double s = on.s_of(projection.nearest_share(start, end, at).value_or(0.0) * length);
        if (&on != &path.front()) s = std::max(s, on.begin);
        if (&on != &path.back()) s = std::min(s, on.end());
        const double away = ui::distance(projection(start + on.x_of(s) / length * (end - start)), at);
        if (away >= least) continue;
        least = away;
        nearest = s;
    }
    return nearest;
}

std::string AskedLine::words(const drawing::DrawOptions& options) const
{
    std::string words;
    for (const drawing::InfluencePicture& kept : found_.kept_pictures)
        words += influence_words(*found_.model, options, kept) + "\n";
    if (!found_.picture->traced) words += influence_words(*found_.model, options, *found_.picture);
    if (found_.standing && !train_.is_unit_load)
        return words + "\n" + train_words(*found_.model, options, *found_.picture, *found_.standing, found_.worst);
    for (const std::string& sentence : sentences(options)) words += "  " + sentence + "\n";
    return words;
}

const drawing::InfluencePicture* AskedLine::picture(const Model& model, std::uint64_t generation,
                                                    const drawing::DrawOptions& options) const
{
    const std::optional<MovingEffect> wanted = effect(model);
    if (!wanted || model.members.empty()) {
        found_.effect.reset(); // what is asked for next is found anew, with what stands on it
        found_.standing.reset();
        return nullptr;
    }
    try {
        if (found_.generation != generation) {
            found_ = {.generation = generation, .model = std::make_shared<const Model>(model)};
            found_.analysis = std::make_shared<femoop::influence::InfluenceAnalysis>(model);
        }
        const ui::DisplayUnits units = display_units(model, options);
        const double force = 1.0 / units.unit(ui::Measure::Force).factor;
        const UnitLoad unit_load{units.text(force, ui::Measure::Force), force};
        const bool is_here = found_.effect == wanted && found_.train == train_ && found_.unit_load == unit_load;
        found_.unit_load = unit_load;
        if (found_.analysis && !is_here) find(*wanted);
    } catch (const femoop::ModelError&) { // the problems say why the model cannot be solved
        found_.effect = wanted;
        found_.train = train_;
        found_.picture.reset();
        found_.standing.reset();
    }
    if (!found_.picture) return nullptr;
    find_kept();
    found_.picture->sentences = sentences(options);
    return &*found_.picture;
}

void AskedLine::find(const MovingEffect& effect) const
{
    const bool is_same_train = found_.train.name == train_.name && found_.train.is_unit_load == train_.is_unit_load &&
                               found_.train.beside == train_.beside;
    const bool is_same_line = found_.picture && found_.effect == effect && is_same_train;
    found_.effect = effect;
    found_.train = train_;
    if (is_same_line && found_.standing) return stand_train();
    found_.picture.reset();
    found_.concealed.reset();
    found_.standing.reset();
    found_.faults.clear();
    const std::vector<femoop::Train>& trains = found_.model->moving_loads.trains;
    const auto train = std::ranges::find(trains, train_.name, &femoop::Train::id);
    if (train == trains.end() && !train_.is_unit_load) return find_line(effect);
    try {
        if (train_.is_unit_load) {
            find_line(effect);
            find_unit_load();
        } else {
            find_line_of_train(*train, effect);
        }
        stand_train();
    } catch (const femoop::ModelError& error) { // the line alone stands, and it is said why
        found_.standing.reset();
        found_.faults = error.faults();
        find_line(effect);
    }
}

const drawing::InfluencePicture& AskedLine::concealed() const
{
    if (!found_.concealed) found_.concealed = drawing::concealed(*found_.picture);
    return *found_.concealed;
}

void AskedLine::find_line(const MovingEffect& effect) const
{
    found_.picture = line_alone(effect);
    found_.picture->motion = found_.analysis->motion(effect);
}

drawing::InfluencePicture AskedLine::line_alone(const MovingEffect& effect) const
{
    const femoop::NodeVector load = femoop::influence::unit_load(found_.model->analysis, {});
    const auto path = femoop::influence::lay_out(*found_.model,
                                                 femoop::influence::usual_path(*found_.model, effect, load));
    return {.path = path, .load = load, .line = found_.analysis->line(path, load, effect)};
}

// Without those whose load would drive a mechanism.
void AskedLine::find_kept() const
{
    std::vector<MovingEffect> wanted = kept(*found_.model);
    std::erase(wanted, *found_.effect);
    if (found_.kept == wanted) return;
    found_.kept = wanted;
    found_.kept_pictures.clear();
    for (const MovingEffect& effect : wanted) {
        try {
            found_.kept_pictures.push_back(line_alone(effect));
        } catch (const femoop::ModelError&) {
            continue;
        }
    }
}

void AskedLine::find_line_of_train(const femoop::Train& train, const MovingEffect& effect) const
{
    if (!found_.trains) found_.trains = std::make_shared<femoop::influence::TrainAnalysis>(*found_.model);
    found_.picture = {.path = found_.trains->path(train),
                      .load = femoop::influence::unit_load(found_.model->analysis, train.load),
                      .line = found_.trains->line(train, effect)};
    found_.picture->motion = found_.analysis->motion(effect);
    found_.standing = {.name = train.id, .train = femoop::influence::moving_train(train, effect)};
    if (train_.beside)
        found_.permanent = found_.trains->permanent({.with = found_.model->find_case(train_.beside->load_case)},
                                                    effect);
    search_line();
}

void AskedLine::find_unit_load() const
{
    found_.standing = {.name = found_.unit_load.name, .train = {.axles = {found_.unit_load.force}}};
    search_line();
}

void AskedLine::search_line() const
{
    found_.search = std::make_shared<const femoop::influence::TrainSearch>(
        found_.picture->line.ordinates, found_.picture->path.nodes(), found_.standing->train);
    found_.worst = found_.search->worst();
    found_.sought.reset();
}

const femoop::influence::Placing& AskedLine::worst_placing() const
{
    return found_.standing->kind == ExtremeKind::Max ? found_.worst.max : found_.worst.min;
}

// Where it is worst, or where it was put.
void AskedLine::stand_train() const
{
    drawing::StandingTrain& standing = *found_.standing;
    const auto& [max, min] = found_.worst;
    const ExtremeKind greater = std::abs(max.value) >= std::abs(min.value) ? ExtremeKind::Max : ExtremeKind::Min;
    standing.kind = train_.kind.value_or(greater);
    const femoop::influence::Placing& worst = worst_placing();
    const std::optional<AskedTrain::Place>& place = train_.place;
    const bool is_put = place && !standing.train.axles.empty();
    const bool is_away = train_.is_unit_load && !is_put && !worst.position; // it does no such thing anywhere
    standing.is_worst = !is_put || (worst.position == place->position && worst.reversed == place->reversed);
    standing.placing = standing.is_worst ? worst : placed(*place, standing.kind);
    if (is_away) standing.placing = placed({}, standing.kind);
    stand_on(*found_.picture, standing);
    find_candidates();
    found_.picture->curve.reset();
    if (train_.is_unit_load) return trace_line();
    if (standing.placing.position) found_.picture->curve = curve();
    load_train();
}

// As far as the load has come; what it does to the structure is seen beside it.
void AskedLine::trace_line() const
{
    constexpr double all = 1.0 - 1e-9;
    const double length = found_.picture->path.length();
    traced_to_ = std::max(traced_to_, *found_.standing->placing.position);
    found_.picture->traced.reset();
    if (traced_to_ < all * length) found_.picture->traced = Stretch{0.0, traced_to_};
    load_train();
    found_.results = femoop::analyse(*found_.loaded);
}

femoop::influence::Placing AskedLine::placed(const AskedTrain::Place& place, ExtremeKind kind) const
{
    const Stretch along = positions(place.reversed); // the path may have become shorter
    return found_.search->at({.position = std::clamp(place.position, along.from, along.to), .reversed = place.reversed},
                             kind);
}

void AskedLine::find_candidates() const
{
    const ExtremeKind kind = found_.standing->kind;
    if (found_.sought != kind) found_.candidates = candidate_positions(*found_.search, kind);
    found_.sought = kind;
}

void AskedLine::load_train() const
{
    const drawing::InfluencePicture& picture = *found_.picture;
    const drawing::StandingTrain& standing = *found_.standing;
    found_.loaded = found_.analysis->model();
    found_.loaded->load_cases = {femoop::influence::standing_train(
        standing.name, picture.path, picture.load, standing.train, standing.placing, picture.line, standing.kind)};
}

drawing::PositionCurve AskedLine::curve() const
{
    const drawing::StandingTrain& standing = *found_.standing;
    const MovingEffect& effect = found_.picture->line.effect;
    drawing::PositionCurve curve{.now = {*standing.placing.position, standing.placing.value},
                                 .path_length = found_.picture->path.length(),
                                 .role = drawing::role_of(effect),
                                 .measure = drawing::measure_of(effect)};
    const auto add = [&](bool is_reversed) {
        const Stretch along = positions(is_reversed);
        curve.runs.push_back(
            {found_.search->over_positions(standing.kind, is_reversed), along.from, along.to, is_reversed});
    };
    add(false);
    if (standing.train.both_directions) add(true);
    for (const CandidatePosition& one : found_.candidates) curve.candidates.push_back({one.position, one.value});
    if (const auto worst = worst_place()) curve.worst = {worst->position, worst_placing().value};
    return curve;
}

std::vector<std::string> AskedLine::sentences(const drawing::DrawOptions& options) const
{
    if (found_.standing && train_.is_unit_load) return trace_sentences(*found_.model, options, *found_.picture);
    if (found_.standing) {
        std::vector<std::string> said = train_sentences(*found_.model, options, *found_.picture, *found_.standing);
        if (train_.beside) said.push_back(sum_with_permanent(options));
        return said;
    }
    std::vector<std::string> sentences = drawing::motion_sentences(*found_.model, *found_.picture, options.tr);
    for (const femoop::Fault& fault : found_.faults) sentences.push_back(sentence(fault, options.tr));
    return sentences;
}

// "with G: −707.8 + 1.35 × 712.7 = 254.4 kip·ft"
std::string AskedLine::sum_with_permanent(const drawing::DrawOptions& options) const
{
    const ui::DisplayUnits units = display_units(*found_.model, options);
    const ui::Measure measure = drawing::measure_of(found_.picture->line.effect);
    const auto [load_case, factor] = *train_.beside;
    const double value = found_.standing->placing.value, sum = found_.permanent + factor * value;
    const std::string of_train = drawing::with_minus(units.number(value, measure));
    std::string term = value < 0.0 ? "(" + of_train + ")" : of_train;
    if (factor != 1.0) term = drawing::with_minus(ui::number_text(factor, options.numbers)) + " × " + term;
    const std::string total = " = " + drawing::with_minus(units.text(sum, measure));
    if (load_case.empty()) return options.tr("in the envelope: {sum}", {{"sum", term + total}});
    return options.tr("with {case}: {sum}",
                      {{"case", load_case},
                       {"sum", drawing::with_minus(units.number(found_.permanent, measure)) + " + " + term + total}});
}

} // namespace frame
