#include "femoop/methods/influence/train/train_analysis.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "femoop/geometry/member_geometry.h"
#include "femoop/methods/influence/load_components.h"
#include "femoop/methods/influence/usual_path.h"
#include "femoop/result/components.h"

namespace femoop::influence {

namespace {

constexpr std::size_t degree_of_force = 1, degree_of_displacement = 3; ///< in the section's place
constexpr double noise = 1e-12;                                        ///< of a usual ordinate
constexpr double largest_force = 1e100; // times a line it is a number still, and times its slope

std::vector<double> values_of(const std::vector<Quantity>& quantities)
{
    std::vector<double> values;
    for (const Quantity& quantity : quantities) values.push_back(quantity.value());
    return values;
}

/// \throws ModelError that names the train or the envelope
void require_in_range(const std::string& id, const MovingTrain& moving, double factor = 1.0)
{
    double sum = std::abs(moving.uniform);
    for (const double axle : moving.axles) sum += std::abs(axle);
    for (const double force : moving.concentrated) sum += std::abs(force);
    if (!(std::abs(factor) * sum <= largest_force)) throw ModelError({{FaultKind::ResultsBeyondRange, {id}}});
}

/// Nothing, where rounding alone is left beside what a unit load does to other effects of this kind.
PiecewiseLine without_noise(PiecewiseLine line, const MovingEffect& effect, const NodeVector& load)
{
    const bool is_displaced = effect.component ? is_displacement(*effect.component)
                                               : effect.quantity == ExpectedQuantity::Displacement;
    if (is_displaced) return line;
    double usual = is_moment(effect) ? line.length() : 1.0;
    if (is_couple(load)) usual /= line.length();
    const double least = noise * usual;
    const bool stands_out = std::ranges::any_of(
        line.pieces, [&](const LinePiece& piece) { // most do so at a piece's end
            return std::abs(piece.value(piece.from)) > least || std::abs(piece.value(piece.to)) > least;
        });
    if (stands_out || line.largest() > least) return line;
    for (LinePiece& piece : line.pieces) piece.coefficients.clear();
    return line;
}

double worse_side(const Curve& curve, MemberComponent component, double x, ExtremeKind kind)
{
    const double before = curve.value(component, x, x > 0.0 ? Side::Before : Side::After);
    const double after = curve.value(component, x, x < curve.length() ? Side::After : Side::Before);
    return kind == ExtremeKind::Max ? std::max(before, after) : std::min(before, after);
}

Placing scaled(Placing placing, double base, double factor)
{
    placing.value = base + factor * placing.value;
    return placing;
}

/// The train alone, as an envelope would have it.
TrainEffect enveloped(TrainEffect of, double base, double factor)
{
    if (factor < 0.0) {
        std::swap(of.max, of.min);
        std::swap(of.max_train, of.min_train);
    }
    of.max = scaled(std::move(of.max), base, factor);
    of.min = scaled(std::move(of.min), base, factor);
    return of;
}

template <class Of> void keep_worse(Of& worst, Of other, double (*value)(const Of&, ExtremeKind))
{
    if (value(other, ExtremeKind::Max) > value(worst, ExtremeKind::Max)) {
        worst.max = other.max;
        worst.max_train = other.max_train;
    }
    if (value(other, ExtremeKind::Min) < value(worst, ExtremeKind::Min)) {
        worst.min = other.min;
        worst.min_train = other.min_train;
    }
}

/// Evenly spaced ones, those of the extremes and the jumps: ascending, each once.
std::vector<double> section_places(const TrainExtreme& extreme, const std::vector<double>& jumps, double length,
                                   std::size_t n)
{
    constexpr double same = 1e-9; // of the length
    std::vector<double> places;
    for (std::size_t i = 0; i + 1 < n; ++i)
        places.push_back(length * static_cast<double>(i) / static_cast<double>(n - 1));
    places.push_back(length);
    for (const auto* more : {&extreme.max.sections, &extreme.min.sections, &jumps})
        places.insert(places.end(), more->begin(), more->end());
    std::ranges::stable_sort(places);
    const auto is_same = [&](double a, double b) { return b - a <= same * length; };
    places.erase(std::unique(places.begin(), places.end(), is_same), places.end());
    places.back() = length;
    return places;
}

/// Is there a jump at a place between the ends?
bool is_within(const std::vector<double>& jumps, double x, double length)
{
    constexpr double same = 1e-9;
    return x > 0.0 && x < length &&
           std::ranges::any_of(jumps, [&](double jump) { return std::abs(jump - x) <= same * length; });
}

double value_at_place(const TrainEffect& of, ExtremeKind kind)
{
    return kind == ExtremeKind::Max ? of.max.value : of.min.value;
}

double value_of_extreme(const TrainExtreme& of, ExtremeKind kind)
{
    return kind == ExtremeKind::Max ? of.max.placing.value : of.min.placing.value;
}

} // namespace

bool is_moment(const MovingEffect& effect)
{
    if (effect.component) return femoop::is_moment(*effect.component);
    return effect.quantity == ExpectedQuantity::Reaction && is_rotation(*effect.dof);
}

MovingTrain moving_train(const Train& train, const MovingEffect& effect)
{
    MovingTrain moving;
    for (const double axle : values_of(train.axles)) moving.axles.push_back(axle * train.impact);
    for (const double spacing : values_of(train.spacings)) moving.spacings.push_back({spacing, spacing});
    for (const SpacingRange& range : train.spacing_ranges)
        moving.spacings.at(range.spacing) = {range.min.value(), range.max.value()};
    moving.both_directions = train.both_directions;
    moving.uniform = train.uniform ? train.uniform->value() : 0.0;
    moving.extent = train.uniform_extent;
    moving.gap = train.gap ? train.gap->value() : 0.0;
    for (const ConcentratedForce& force : train.concentrated) {
        const bool is_other = force.for_others && !is_moment(effect);
        moving.concentrated.push_back((is_other ? *force.for_others : force.for_moments).value());
    }
    require_in_range(train.id, moving);
    return moving;
}

std::vector<MovingEffect> default_effects(const Model& model, std::size_t n)
{
    std::vector<MovingEffect> effects;
    for (const MovingEffect& of_member : default_extremes(model)) {
        const double length = geometry_of(model, model[*of_member.member]).length;
        for (std::size_t i = 0; i < n; ++i) {
            const bool is_last = i + 1 == n;
            const double x = is_last ? length : length * static_cast<double>(i) / static_cast<double>(n - 1);
            effects.push_back(at_section(of_member, x, length));
        }
    }
    for (std::size_t i = 0; i < model.nodes.size(); ++i)
        std::ranges::move(reactions_at(model, NodeId(i)), std::back_inserter(effects));
    return effects;
}

double search_size(const Model& model, const Train& train)
{
    const MovingEffect moment{.quantity = ExpectedQuantity::Extreme, .component = MemberComponent::Mz};
    return search_size(moving_train(train, moment), members_of(model, train.path).size());
}

MovingEffect at_section(MovingEffect effect, double x, double length)
{
    const bool is_displacement_there = is_displacement(*effect.component);
    effect.quantity = is_displacement_there ? ExpectedQuantity::Displacement : ExpectedQuantity::SectionForce;
    effect.at = Quantity(x);
    effect.side = x >= length ? Side::Before : Side::After;
    return effect;
}

std::vector<MovingEffect> default_extremes(const Model& model)
{
    std::vector<MovingEffect> effects;
    for (std::size_t i = 0; i < model.members.size(); ++i)
        for (const MemberComponent component : section_force_components(model.analysis))
            effects.push_back({.quantity = ExpectedQuantity::Extreme, .member = MemberId(i), .component = component});
    return effects;
}

TrainAnalysis::TrainAnalysis(const Model& model, const AnalysisOptions& options)
    : model_(model), options_(options), lines_(model, options)
{}

PathLayout TrainAnalysis::path(const Train& train) const { return lay_out(model_, members_of(model_, train.path)); }

std::vector<TrainEffect> TrainAnalysis::effects(const Train& train, std::span<const MovingEffect> effects)
{
    const PathLayout layout = path(train);
    std::vector<TrainEffect> all;
    const NodeVector load = unit_load(model_.analysis, train.load);
    for (const InfluenceLine& line : lines_.lines(layout, load, effects)) {
        const TrainSearch search(without_noise(line.ordinates, line.effect, load), layout.nodes(),
                                 moving_train(train, line.effect));
        const auto [max, min] = search.worst();
        all.push_back({line.effect, max, min, &train, &train});
    }
    return all;
}

InfluenceLine TrainAnalysis::line(const Train& train, const MovingEffect& effect)
{
    const NodeVector load = unit_load(model_.analysis, train.load);
    InfluenceLine line = lines_.line(path(train), load, effect);
    line.ordinates = without_noise(std::move(line.ordinates), effect, load);
    return line;
}

TrainSearch TrainAnalysis::search(const Train& train, const MovingEffect& effect)
{
    return {line(train, effect).ordinates, path(train).nodes(), moving_train(train, effect)};
}

SectionLines TrainAnalysis::section_lines(const Train& train, const MovingEffect& effect)
{
    const double length = geometry_of(model_, model_[*effect.member]).length;
    const auto source = [this, layout = path(train), load = unit_load(model_.analysis, train.load), effect,
                         length](double x) -> PiecewiseLine {
        return without_noise(lines_.line(layout, load, at_section(effect, x, length)).ordinates, effect, load);
    };
    return {source, length, is_displacement(*effect.component) ? degree_of_displacement : degree_of_force};
}

TrainExtreme TrainAnalysis::extreme(const Train& train, const MovingEffect& effect)
{
    const SectionLines lines = section_lines(train, effect);
    const std::vector<double> ends = path(train).nodes();
    const MovingTrain moving = moving_train(train, effect);
    return {effect, worst_section(lines, ends, moving, ExtremeKind::Max),
            worst_section(lines, ends, moving, ExtremeKind::Min), &train, &train};
}

const Results& TrainAnalysis::permanent_results()
{
    if (!permanent_) permanent_ = LinearStatic(model_, options_).solve(model_);
    return *permanent_;
}

double TrainAnalysis::permanent(const MovingEnvelope& envelope, const MovingEffect& effect)
{
    return envelope.with ? effect_in(effect, permanent_results()[*envelope.with]) : 0.0;
}

std::vector<TrainEffect> TrainAnalysis::effects(const MovingEnvelope& envelope, std::span<const MovingEffect> asked)
{
    std::vector<TrainEffect> worst;
    for (const TrainId id : envelope.trains) {
        const Train& train = model_.moving_loads.trains[id.index];
        for (const MovingEffect& effect : asked)
            require_in_range(envelope.id, moving_train(train, effect), envelope.factor);
        std::vector<TrainEffect> all = effects(train, asked);
        for (std::size_t i = 0; i < all.size(); ++i) {
            all[i] = enveloped(std::move(all[i]), permanent(envelope, all[i].effect), envelope.factor);
            if (i < worst.size()) keep_worse(worst[i], std::move(all[i]), value_at_place);
            else worst.push_back(std::move(all[i]));
        }
    }
    return worst;
}

std::vector<double> TrainAnalysis::load_points(const MovingEnvelope& envelope, MemberId member)
{
    return envelope.with ? permanent_results()[*envelope.with].curve(member).breaks() : std::vector<double>{};
}

Permanent TrainAnalysis::permanent_along(const MovingEnvelope& envelope, const MovingEffect& effect, ExtremeKind kind)
{
    if (!envelope.with) return {[](double) { return 0.0; }, {}, envelope.factor};
    const Curve curve = permanent_results()[*envelope.with].curve(*effect.member);
    const MemberComponent component = *effect.component;
    return {[curve, component, kind](double x) { return worse_side(curve, component, x, kind); }, curve.breaks(),
            envelope.factor};
}

TrainExtreme TrainAnalysis::extreme(const MovingEnvelope& envelope, const MovingEffect& effect)
{
    const Permanent above = permanent_along(envelope, effect, ExtremeKind::Max);
    const Permanent below = permanent_along(envelope, effect, ExtremeKind::Min);
    std::optional<TrainExtreme> worst;
    for (const TrainId id : envelope.trains) {
        const Train& train = model_.moving_loads.trains[id.index];
        const SectionLines lines = section_lines(train, effect);
        const std::vector<double> ends = path(train).nodes();
        const MovingTrain moving = moving_train(train, effect);
        require_in_range(envelope.id, moving, envelope.factor);
        TrainExtreme one{effect, worst_section(lines, ends, moving, ExtremeKind::Max, &above),
                         worst_section(lines, ends, moving, ExtremeKind::Min, &below), &train, &train};
        if (worst) keep_worse(*worst, std::move(one), value_of_extreme);
        else worst = std::move(one);
    }
    return worst.value();
}

MemberEnvelope TrainAnalysis::along_member(const MovingEnvelope& envelope, const MovingEffect& effect, std::size_t n)
{
    const double length = geometry_of(model_, model_[*effect.member]).length;
    MemberEnvelope found{extreme(envelope, effect), {}};
    const std::vector<double> jumps = load_points(envelope, *effect.member);
    std::vector<MovingEffect> asked;
    double path_length = 0.0;
    for (const TrainId id : envelope.trains)
        path_length = std::max(path_length, path(model_.moving_loads.trains[id.index]).length());
    const double hair = hair_within(length, path_length); // what stands at the very end of a path lies beyond it
    for (const double x : section_places(found.extreme, jumps, length, n)) {
        asked.push_back(at_section(effect, std::clamp(x, hair, length - hair), length));
        if (!is_within(jumps, x, length)) continue;
        asked.push_back(asked.back());
        asked[asked.size() - 2].side = Side::Before;
    }
    found.sections = effects(envelope, asked);
    return found;
}

} // namespace femoop::influence
