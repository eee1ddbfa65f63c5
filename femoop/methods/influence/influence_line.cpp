#include "femoop/methods/influence/influence_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "femoop/analysis/mechanism.h"
#include "femoop/load/place_along.h"
#include "femoop/methods/influence/dislocation.h"
#include "femoop/methods/influence/effect_name.h"
#include "femoop/methods/influence/load_components.h"
#include "femoop/methods/influence/usual_path.h"
#include "femoop/methods/unit_load_case.h"
#include "femoop/result/components.h"
#include "femoop/result/curve_reader.h"

namespace femoop::influence {

namespace {

constexpr double end_of_curve = 1e-9; // of its length
constexpr double negligible = 1e-14;  // of the largest ordinate: a coefficient that adds less is rounding
constexpr double doubtful = 1e-8;     // of the largest ordinate: a load on the path should not say more against it
constexpr double least_effect = 1e-6; // of a unit load: a line with smaller ordinates is held against this
constexpr double no_force = 1e-14;    // of a unit load: a line with no larger ordinates is rounding
constexpr double golden_ratio = 0.6180339887498949;

bool is_section_force(const MovingEffect& effect) { return effect.member && !is_displacement(*effect.component); }
bool is_force(const MovingEffect& effect)
{
    return is_section_force(effect) || effect.quantity == ExpectedQuantity::Reaction;
}

/// The support's axes as rows, in global ones.
double along_support_axis(const Discretisation::SupportRow& support, Dof axis, Dof global)
{
    const double c = std::cos(support.angle), s = std::sin(support.angle);
    if (is_rotation(axis) || axis == Dof::uz) return axis == global ? 1.0 : 0.0;
    if (axis == Dof::ux) return global == Dof::ux ? c : (global == Dof::uy ? s : 0.0);
    return global == Dof::ux ? -s : (global == Dof::uy ? c : 0.0);
}

/// The support moved by 1 against a reaction: what holds it moves, in its own axes.
Settlement settlement_against(const Discretisation::SupportRow& support, Dof reaction)
{
    Settlement settlement{.node = support.node, .components = {}};
    for (const Dof axis : all_dofs) {
        const double part = along_support_axis(support, axis, reaction);
        const bool holds = support.blocked.contains(axis) || support.springs[index(axis)] > 0.0;
        if (holds && part != 0.0) settlement.components.push_back({.dof = axis, .value = -part});
    }
    return settlement;
}

std::array<LocalDisplacement, 2> ends_of(const Curve& curve)
{
    return {curve.displacement(0.0), curve.displacement(curve.length(), Side::Before)};
}

/// Coefficients that rounding alone left are none, beside the line's largest ordinate and what a force of a unit load
/// is. \param unit_force  0 of a displacement
void clean_coefficients(PiecewiseLine& line, double unit_force)
{
    const double rounding = std::max(negligible * line.largest(), no_force * unit_force);
    for (LinePiece& piece : line.pieces) {
        double power = 1.0;
        for (double& c : piece.coefficients) {
            if (std::abs(c) * power <= rounding) c = 0.0;
            power *= piece.length();
        }
        while (!piece.coefficients.empty() && piece.coefficients.back() == 0.0) piece.coefficients.pop_back();
    }
}

/// Of a displacement that a support holds nothing is left.
void clean(InfluenceLine& line, const Model& model, double unit_force)
{
    if (holding_support(model, line.effect))
        for (LinePiece& piece : line.ordinates.pieces) piece.coefficients.clear();
    clean_coefficients(line.ordinates, unit_force);
}

/// Takes the pieces of one member of the path; of power series those up to the section, and those behind it, make one
/// stretch.
void append(InfluenceLine& line, std::vector<LinePiece> pieces, MemberId member, bool is_series,
            std::optional<double> section)
{
    const double near = section ? end_of_member * (pieces.back().to - pieces.front().from) : 0.0;
    bool is_first = true;
    for (LinePiece& piece : pieces) {
        const bool is_cut = is_first || (section && std::abs(piece.from - *section) <= near);
        if (is_series && !is_cut) {
            line.stretches.back().to = piece.to;
            ++line.stretches.back().n_pieces;
        } else {
            line.stretches.push_back({.member = member,
                                      .from = piece.from,
                                      .to = piece.to,
                                      .is_series = is_series,
                                      .first_piece = line.ordinates.pieces.size()});
        }
        line.ordinates.pieces.push_back(std::move(piece));
        is_first = false;
    }
}

bool is_series(const Discretisation& structure, MemberId member)
{
    const MemberEndConditions* conditions = structure.end_conditions_of(member);
    const bool bends = conditions == nullptr || conditions->constraint != Constraint::Rigid;
    const Beam& beam = structure.properties_of(member).xy;
    return bends && (beam.foundation > 0.0 || !beam.taper.is_prismatic());
}

/// Is a member so short or stiff beside the structure that its forces are differences of what doubles round?
bool loses_digits(const Discretisation& structure)
{
    constexpr double bearable = 1e5; // times the stiffness of the structure
    const double size = structure.size();
    double softest = std::numeric_limits<double>::infinity(), stiffest = 0.0;
    for (std::size_t i = 0; i < structure.members.size(); ++i) {
        const double EI = structure.properties_of(MemberId(i)).xy.EI;
        if (!(EI > 0.0)) continue;
        softest = std::min(softest, EI);
        stiffest = std::max(stiffest, EI * std::pow(size / structure.geometry(MemberId(i)).length, 3));
    }
    return stiffest > bearable * softest;
}

LoadCase load_at(const PathLayout& path, double s, const NodeVector& load)
{
    const PathPlace place = path.place(s);
    return {.id = "path",
            .members = {{place.member, PointLoad{.at = Quantity(place.x), .components = components_of(load)}}}};
}

/// Where loads on a path prove its lines: inside a member near its begin, middle and end.
std::vector<double> proof_places(const PathLayout& path)
{
    std::vector<double> places;
    const std::size_t last = path.members.size() - 1;
    for (const std::size_t i : {last / 5, last / 2, last - last / 7}) {
        const double s = path.members[i].s_of(golden_ratio * path.members[i].length);
        if (places.empty() || places.back() != s) places.push_back(s);
    }
    return places;
}

/// At the place of an effect along its member; at the end the - side.
double along_member(const MovingEffect& effect, const Curve& curve)
{
    const double x = along(*effect.at, curve.length());
    const bool is_end = x >= curve.length() * (1.0 - end_of_curve);
    return curve.value(*effect.component, x, is_end ? Side::Before : effect.side.value_or(Side::After));
}

} // namespace

double effect_in(const MovingEffect& effect, const Curve& curve) { return along_member(effect, curve); }

double effect_in(const MovingEffect& effect, const CaseResult& result)
{
    if (effect.member) return effect_in(effect, result.curve(*effect.member));
    const NodeVector all = effect.quantity == ExpectedQuantity::Reaction ? result.reaction(*effect.node)
                                                                         : result.displacement(*effect.node);
    return all[index(*effect.dof)];
}

InfluenceAnalysis::InfluenceAnalysis(const Model& model, const AnalysisOptions& options)
    : model_(without_loads(model)),
      analysis_(model_, options),
      structure_(discretise(model_)),
      loses_digits_(loses_digits(structure_))
{}

void InfluenceAnalysis::note(const std::vector<Fault>& warnings)
{
    for (Fault warning : warnings) {
        if (warning.kind == FaultKind::InaccurateCase) warning = {FaultKind::InaccurateLines, {warning.arguments[1]}};
        const bool is_of_unit = warning.kind == FaultKind::HugeDisplacement; // a unit is not a real load
        if (!is_of_unit && std::ranges::find(warnings_, warning) == warnings_.end()) warnings_.push_back(warning);
    }
}

/// The cases that are solved for lines are none of the model's: what is said of one is said of the line.
ModelError InfluenceAnalysis::refusal(const ModelError& error, const PathLayout& path, const MovingEffect& effect) const
{
    const auto node = [&](const PathMember& on, bool is_end) {
        return model_[model_[on.member].nodes[is_end != on.is_reversed ? 1 : 0]].id;
    };
    std::vector<Fault> faults;
    for (Fault fault : error.faults()) {
        const bool is_ill = fault.kind == FaultKind::IllConditionedCase;
        if (is_ill || fault.kind == FaultKind::ResultsBeyondRange)
            fault = {is_ill ? FaultKind::IllConditionedLine : FaultKind::LineBeyondRange,
                     {effect_name(model_, effect), node(path.members.front(), false), node(path.members.back(), true)}};
        if (std::ranges::find(faults, fault) == faults.end()) faults.push_back(std::move(fault));
    }
    return ModelError(std::move(faults));
}

Results InfluenceAnalysis::solve(std::vector<LoadCase> cases)
{
    model_.load_cases = std::move(cases);
    Results results = analysis_.solve(model_);
    note(results.warnings());
    return results;
}

void InfluenceAnalysis::require_undriven(const PathLayout& path, const NodeVector& load)
{
    std::vector<MemberId> members;
    for (const PathMember& on : path.members) members.push_back(on.member);
    if (members == undriven_path_ && load == undriven_load_) return;
    LoadCase everywhere{.id = "path"};
    double factor = 1.0;
    for (const PathMember& on : path.members)
        for (const double share : {0.0, 0.3, 0.8, 1.0}) {
            factor = std::fmod(factor + golden_ratio, 1.0); // no two alike, whose moments might cancel
            const std::vector<Component> components = components_of(load, 1.0 + factor);
            everywhere.members.push_back(
                {on.member, PointLoad{.at = Percent{100.0 * share}, .components = components}});
        }
    solve({std::move(everywhere)});
    undriven_path_ = std::move(members);
    undriven_load_ = load;
}

double InfluenceAnalysis::place(const MovingEffect& effect) const
{
    const double L = structure_.geometry(*effect.member).length;
    return along(*effect.at, L);
}

bool InfluenceAnalysis::is_direct(const MovingEffect& effect) const
{
    return structure_.has_constraints && (effect.quantity == ExpectedQuantity::Reaction || is_section_force(effect));
}

InfluenceAnalysis::Adjoint InfluenceAnalysis::adjoint(const MovingEffect& effect) const
{
    Adjoint adjoint{.effect = &effect, .load_case = {.id = effect_name(model_, effect)}};
    LoadCase& load_case = adjoint.load_case;
    if (effect.quantity == ExpectedQuantity::Reaction) {
        if (const auto* support = structure_.support_of(*effect.node))
            load_case.settlements.push_back(settlement_against(*support, *effect.dof));
    } else if (is_section_force(effect)) {
        const Dislocation dislocation(structure_, *effect.member, *effect.component, place(effect));
        for (std::size_t end = 0; end < 2; ++end)
            for (const NodeVector& part : {dislocation.node_loads()[end].high, dislocation.node_loads()[end].low})
                load_case.nodes.push_back({model_[*effect.member].nodes[end], components_of(part)});
    } else {
        load_case = unit_load_case(model_, effect, load_case.id);
    }
    return adjoint;
}

MemberMotion InfluenceAnalysis::motion_in(const Curve& curve, MemberId member, const MovingEffect& effect) const
{
    if (effect.member != member || !is_section_force(effect)) return motion_of(curve, structure_, member);
    return Dislocation(structure_, member, *effect.component, place(effect)).motion(ends_of(curve));
}

InfluenceLine InfluenceAnalysis::line_of(const PathLayout& path, const NodeVector& load, const MovingEffect& effect,
                                         const CaseResult& moved) const
{
    CurveReader reader(moved);
    InfluenceLine line{.effect = effect, .ordinates = {}, .stretches = {}, .nodes = path.nodes()};
    for (const PathMember& on : path.members) {
        const Curve& curve = reader.read(on.member);
        const MemberMotion motion = motion_in(curve, on.member, effect);
        append(line, work_along(on, motion, structure_.geometry(on.member), load), on.member,
               is_series(structure_, on.member),
               effect.member == on.member ? std::optional(on.s_of(place(effect))) : std::nullopt);
    }
    clean(line, model_, is_force(effect) ? unit_effect(effect, load) : 0.0);
    return line;
}

std::vector<InfluenceLine> InfluenceAnalysis::adjoint_lines(const PathLayout& path, const NodeVector& load,
                                                            const std::vector<Adjoint>& adjoints)
{
    std::vector<LoadCase> cases;
    for (const Adjoint& each : adjoints) cases.push_back(each.load_case);
    const std::vector<double> places = loses_digits_ ? proof_places(path) : std::vector<double>();
    for (const double s : places) cases.push_back(load_at(path, s, load));
    const Results results = solve(std::move(cases));
    std::vector<InfluenceLine> lines;
    for (std::size_t i = 0; i < adjoints.size(); ++i) {
        const MovingEffect& effect = *adjoints[i].effect;
        InfluenceLine line = line_of(path, load, effect, results[CaseId(i)]);
        const double largest = places.empty()
                                   ? 0.0
                                   : std::max(line.ordinates.largest(), least_effect * unit_effect(effect, load));
        bool is_proved = true;
        for (std::size_t k = 0; k < places.size(); ++k) {
            const double direct = effect_in(effect, results[CaseId(adjoints.size() + k)]);
            is_proved = is_proved && std::abs(line.ordinates.value(places[k]) - direct) <= doubtful * largest;
        }
        lines.push_back(is_proved ? std::move(line) : direct_line(path, load, effect));
    }
    return lines;
}

/// What an effect might be, of a unit load.
double InfluenceAnalysis::unit_effect(const MovingEffect& effect, const NodeVector& load) const
{
    const bool is_turning = effect.member ? is_moment(*effect.component) : is_rotation(*effect.dof);
    const double size = structure_.size();
    return (is_turning ? size : 1.0) / (is_couple(load) ? size : 1.0);
}

// Loads on the path may do what the dislocation cannot: a couple spins a node that hinges leave free in part.
InfluenceLine InfluenceAnalysis::adjoint_line(const PathLayout& path, const NodeVector& load, Adjoint adjoint)
{
    const MovingEffect& effect = *adjoint.effect;
    try {
        return std::move(adjoint_lines(path, load, {std::move(adjoint)}).front());
    } catch (const ModelError&) {
        return direct_line(path, load, effect);
    }
}

std::vector<SampledStretch> InfluenceAnalysis::stretches_of(const PathMember& on, const MovingEffect& effect) const
{
    constexpr std::size_t cubic = 3, of_series = 9; // over half of what a power series bears
    std::vector<double> cuts{on.begin, on.end()};
    if (effect.member == on.member) {
        const double x = place(effect), near = end_of_member * on.length;
        if (x > near && x < on.length - near) cuts.insert(cuts.begin() + 1, on.s_of(x));
    }
    const bool is_series = influence::is_series(structure_, on.member);
    const double longest = is_series ? 0.5 * structure_.properties_of(on.member).xy.longest_piece() : on.length;
    std::vector<SampledStretch> stretches;
    for (std::size_t i = 1; i < cuts.size(); ++i) {
        const double from = cuts[i - 1], length = cuts[i] - from;
        const auto n = static_cast<std::size_t>(std::max(1.0, std::ceil(length / longest)));
        const auto at = [&](std::size_t k) {
            return k == n ? cuts[i] : from + length * static_cast<double>(k) / static_cast<double>(n);
        };
        for (std::size_t k = 0; k < n; ++k) stretches.emplace_back(at(k), at(k + 1), is_series ? of_series : cubic);
    }
    return stretches;
}

InfluenceLine InfluenceAnalysis::direct_line(const PathLayout& path, const NodeVector& load, const MovingEffect& effect)
{
    InfluenceLine line{.effect = effect, .ordinates = {}, .stretches = {}, .nodes = path.nodes()};
    for (const PathMember& on : path.members) {
        const std::vector<SampledStretch> stretches = stretches_of(on, effect);
        std::vector<LoadCase> cases;
        for (const SampledStretch& stretch : stretches)
            for (const double s : stretch.places())
                cases.push_back({.id = effect_name(model_, effect),
                                 .members = {{on.member, PointLoad{.at = Quantity(on.x_of(s)),
                                                                   .components = components_of(load)}}}});
        const Results results = solve(std::move(cases));
        std::vector<LinePiece> pieces;
        std::size_t next = 0;
        for (const SampledStretch& stretch : stretches) {
            std::vector<double> values;
            for (std::size_t i = 0; i < stretch.places().size(); ++i)
                values.push_back(effect_in(effect, results[CaseId(next++)]));
            pieces.push_back(stretch.piece(values));
        }
        append(line, std::move(pieces), on.member, is_series(structure_, on.member),
               effect.member == on.member ? std::optional(on.s_of(place(effect))) : std::nullopt);
    }
    clean(line, model_, is_force(effect) ? unit_effect(effect, load) : 0.0);
    return line;
}

InfluenceLine InfluenceAnalysis::line(const PathLayout& path, const NodeVector& load, const MovingEffect& effect)
{
    return std::move(lines(path, load, std::span(&effect, 1)).front());
}

std::vector<InfluenceLine> InfluenceAnalysis::lines(const PathLayout& path, const NodeVector& load,
                                                    std::span<const MovingEffect> effects)
{
    try {
        return solved_lines(path, load, effects);
    } catch (const MechanismError&) {
        throw;
    } catch (const ModelError& error) {
        if (effects.empty()) throw;
        throw refusal(error, path, effects.front());
    }
}

std::vector<InfluenceLine> InfluenceAnalysis::solved_lines(const PathLayout& path, const NodeVector& load,
                                                           std::span<const MovingEffect> effects)
{
    require_undriven(path, load);
    std::vector<InfluenceLine> found(effects.size());
    std::vector<Adjoint> adjoints;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < effects.size(); ++i) {
        if (is_direct(effects[i])) {
            found[i] = direct_line(path, load, effects[i]);
            continue;
        }
        adjoints.push_back(adjoint(effects[i]));
        places.push_back(i);
    }
    if (adjoints.size() == 1) found[places[0]] = adjoint_line(path, load, std::move(adjoints[0]));
    if (adjoints.size() < 2) return found;
    try {
        std::vector<InfluenceLine> lines = adjoint_lines(path, load, adjoints);
        for (std::size_t i = 0; i < lines.size(); ++i) found[places[i]] = std::move(lines[i]);
    } catch (const ModelError&) { // one of them spoils all
        for (std::size_t i = 0; i < adjoints.size(); ++i)
            found[places[i]] = adjoint_line(path, load, std::move(adjoints[i]));
    }
    return found;
}

std::vector<MemberMotion> InfluenceAnalysis::motion(const MovingEffect& effect)
{
    if (is_direct(effect) || holding_support(model_, effect)) return {};
    std::vector<MemberMotion> motions;
    try {
        const Results results = solve({adjoint(effect).load_case});
        CurveReader reader(results[CaseId(0)]);
        for (std::size_t i = 0; i < model_.members.size(); ++i)
            motions.push_back(motion_in(reader.read(MemberId(i)), MemberId(i), effect));
    } catch (const ModelError&) { // then `line` is put together from unit loads
        motions.clear();
    }
    return motions;
}

std::vector<LineStation> stations(const InfluenceLine& line, std::size_t n)
{
    const double near = end_of_member * line.ordinates.length();
    const std::vector<double> jumps = line.ordinates.jumps();
    std::vector<double> places = jumps;
    for (std::size_t m = 1; m < line.nodes.size(); ++m)
        for (std::size_t i = 0; i < n; ++i) {
            const double share = static_cast<double>(i) / static_cast<double>(n - 1);
            const double s = i + 1 == n ? line.nodes[m]
                                        : line.nodes[m - 1] + share * (line.nodes[m] - line.nodes[m - 1]);
            const auto is_here = [&](double place) { return std::abs(place - s) <= near; };
            if (std::ranges::none_of(places, is_here)) places.push_back(s);
        }
    std::ranges::sort(places);
    std::vector<LineStation> found;
    for (const double s : places) {
        const bool jumps_here = std::ranges::find(jumps, s) != jumps.end();
        if (jumps_here) found.push_back({s, line.ordinates.value(s, Side::Before)});
        found.push_back({s, line.ordinates.value(s, Side::After)});
    }
    return found;
}

InfluenceLines influence_lines(const Model& model, std::span<const InfluenceLineDefinition> definitions,
                               const AnalysisOptions& options)
{
    InfluenceAnalysis analysis(model, options);
    InfluenceLines found{.lines = std::vector<InfluenceLine>(definitions.size()), .warnings = {}};
    std::vector<bool> is_done(definitions.size(), false);
    for (std::size_t i = 0; i < definitions.size(); ++i) {
        if (is_done[i]) continue;
        const std::vector<MemberId>& members = members_of(model, definitions[i].path);
        const NodeVector load = unit_load(model.analysis, definitions[i].load);
        std::vector<std::size_t> together;
        std::vector<MovingEffect> effects;
        for (std::size_t k = i; k < definitions.size(); ++k) {
            const bool is_alike = members_of(model, definitions[k].path) == members &&
                                  unit_load(model.analysis, definitions[k].load) == load;
            if (!is_alike) continue;
            is_done[k] = true;
            together.push_back(k);
            effects.push_back(definitions[k].effect);
        }
        std::vector<InfluenceLine> lines = analysis.lines(lay_out(model, members), load, effects);
        for (std::size_t k = 0; k < together.size(); ++k) found.lines[together[k]] = std::move(lines[k]);
    }
    found.warnings = analysis.warnings();
    return found;
}

} // namespace femoop::influence
