#include "femoop/methods/derivation/derivation.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include "femoop/element/analysis_model.h"
#include "femoop/load/case_terms.h"
#include "femoop/methods/derivation/lost_digits.h"
#include "femoop/methods/derivation/member_alone.h"
#include "femoop/methods/derivation/member_steps.h"
#include "femoop/methods/derivation/paper_system.h"
#include "femoop/methods/derivation/system_steps.h"
#include "femoop/methods/influence/effect_name.h"
#include "femoop/methods/influence/influence_line.h"
#include "femoop/methods/influence/train/train_analysis.h"
#include "femoop/model/quantity/six_digits.h"
#include "femoop/result/curve_reader.h"

namespace femoop::derivation {

namespace {

using influence::effect_in;

/// Of the numbers whose round-off the effect may be.
double size_of(const MovingEffect& effect, const CaseResult& result)
{
    const Magnitudes most = result.magnitudes();
    if (effect.component) return most.of(*effect.component);
    return effect.quantity == ExpectedQuantity::Reaction ? most.force_of(*effect.dof)
                                                         : most.displacement_of(*effect.dof);
}

double value_of(const MovingEffect& effect, const CaseResult& result)
{
    if (is_resultant(effect)) {
        const NodeVector reaction = result.reaction(*effect.node);
        return std::hypot(reaction[index(Dof::ux)], reaction[index(Dof::uy)]);
    }
    return without_rounding(effect_in(effect, result), size_of(effect, result));
}

constexpr double round_off = 1e-12; ///< of the largest force on the ends of a member

void append(std::vector<Step>& steps, std::vector<Step> more) { std::ranges::move(more, std::back_inserter(steps)); }

/// Numbers that add up.
class Sum {
public:
    void add(std::string name, double part)
    {
        names_.push_back(std::move(name));
        parts_.push_back(part);
    }
    /// One below the other, the sum at the foot.
    NamedMatrix as(const std::string& symbol) const
    {
        const auto n = static_cast<Eigen::Index>(parts_.size());
        NamedMatrix matrix{symbol, names_, {""}, Eigen::MatrixXd(n + 1, 1)};
        matrix.rows.push_back(symbol);
        matrix.values.topRows(n) = Eigen::Map<const Eigen::VectorXd>(parts_.data(), n);
        matrix.values(n, 0) = matrix.values.topRows(n).sum();
        return matrix;
    }

private:
    std::vector<std::string> names_;
    std::vector<double> parts_;
};

std::vector<MemberId> members_at(const Model& model, NodeId node)
{
    std::vector<MemberId> members;
    for (std::size_t i = 0; i < model.members.size(); ++i)
        if (std::ranges::find(model.members[i].nodes, node) != model.members[i].nodes.end()) members.emplace_back(i);
    return members;
}

/// Writes down one number of one structure.
class NumberSteps {
public:
    NumberSteps(const Model& model, const Results& results, const MovingEffect& effect)
        : model_(model), results_(results), effect_(effect), system_(model)
    {
        const std::vector<MemberId> members = effect.member ? std::vector{*effect.member}
                                                            : members_at(model, *effect.node);
        for (const MemberId member : members) members_.emplace_back(system_, member);
    }

    /// What is the same in all load cases comes with the first.
    std::vector<Step> steps(CaseId load_case, bool is_first) const
    {
        const CaseResult result = results_[load_case];
        if (effect_.member) return along_member(load_case, result, is_first);
        if (effect_.quantity == ExpectedQuantity::Reaction) return reaction(load_case, result, is_first);
        return displacement(load_case, result, is_first);
    }

    const SystemTrace& system() const { return system_.trace(); }

    Step combination(const CaseTerms& terms) const
    {
        NamedMatrix factors{"factors", {}, {"factor", "value"}, {}};
        factors.values.resize(static_cast<Eigen::Index>(terms.terms.size()), 2);
        Sum sum;
        for (const CaseTerms::Term& term : terms.terms) {
            const double value = value_of(effect_, results_[CaseId(term.load_case)]);
            const std::string& name = model_.load_cases[term.load_case].id;
            factors.values.row(static_cast<Eigen::Index>(factors.rows.size())) << term.factor, value;
            factors.rows.push_back(name);
            sum.add(name, term.factor * value);
        }
        return {.kind = StepKind::Combination,
                .member = effect_.member,
                .node = effect_.node,
                .matrices = {factors, sum.as(symbol())}};
    }

private:
    std::string symbol() const { return influence::effect_name(model_, effect_); }

    std::vector<Step> along_member(CaseId load_case, const CaseResult& result, bool is_first) const
    {
        const MemberSteps& member = members_.front();
        const SystemSteps system(system_, member.rows(), about());
        std::vector<Step> steps;
        if (is_first) {
            steps = member.stiffness();
            append(steps, system.order());
        }
        steps.push_back(member.fixed_end_forces(load_case));
        append(steps, system.solved(load_case, result));
        append(steps, system.tie_forces(load_case, result));
        steps.push_back(member.end_displacements(load_case, result));
        steps.push_back(member.end_forces(load_case, result));
        steps.push_back(superposition(load_case, result));
        return steps;
    }

    /// A step that says which member or node it is about.
    Step about() const { return {.member = effect_.member, .node = effect_.node, .matrices = {}}; }

    /// The member's nodes move and carry no loads, and the loads act while the nodes are held.
    Step superposition(CaseId load_case, const CaseResult& result) const
    {
        if (members_.front().is_tied()) return tied_superposition(load_case, result);
        const MemberAlone alone = take_out(model_, *effect_.member, model_.load_cases[load_case.index], result);
        MovingEffect effect = effect_;
        effect.member = MemberAlone::member;
        const double size = size_of(effect_, result);
        Sum sum;
        sum.add("u'", without_rounding(effect_in(effect, alone.moved()), size));
        sum.add("f0'", without_rounding(effect_in(effect, alone.loaded()), size));
        return {.kind = StepKind::Superposition,
                .member = effect_.member,
                .load_case = load_case,
                .matrices = {sum.as(symbol())}};
    }

    /// Of a member that is tied too: what ties it goes through it.
    Step tied_superposition(CaseId load_case, const CaseResult& result) const
    {
        CurveReader reader(result);
        const double size = size_of(effect_, result);
        Sum sum;
        const auto add = [&](const char* name, CurvePart part) {
            sum.add(name, without_rounding(influence::effect_in(effect_, reader.read(*effect_.member, part)), size));
        };
        add("u'", CurvePart::Motion);
        add("f0'", CurvePart::Loads);
        add("c'", CurvePart::Constraint);
        return {.kind = StepKind::Superposition,
                .member = effect_.member,
                .load_case = load_case,
                .matrices = {sum.as(symbol())}};
    }

    /// On the node itself, global axes.
    NodeVector loads_on(NodeId node, CaseId load_case) const
    {
        NodeVector sum{};
        for (const NodeLoad& load : model_.load_cases[load_case.index].nodes)
            if (load.node == node)
                for (const Component& component : load.components) sum[index(component.dof)] += component.value;
        return sum;
    }

    /// The forces of all members that meet the node, less the loads on it, are what the support brings.
    std::vector<Step> reaction(CaseId load_case, const CaseResult& result, bool is_first) const
    {
        const NodeId node = *effect_.node;
        const SystemSteps system(system_, rows_of_members(), about());
        std::vector<Step> steps;
        if (is_first) {
            for (const MemberSteps& member : members_) append(steps, member.stiffness());
            append(steps, system.order());
        }
        for (const MemberSteps& member : members_) steps.push_back(member.fixed_end_forces(load_case));
        for (const Dof dof : moved_by_support(load_case)) steps.push_back(held(dof, load_case, result));
        append(steps, system.solved(load_case, result));
        append(steps, system.tie_forces(load_case, result));
        Sum sum;
        double largest = 0.0;
        for (const MemberSteps& member : members_) {
            steps.push_back(member.end_displacements(load_case, result));
            steps.push_back(member.node_forces(node, load_case, result));
            largest = std::max(largest, steps.back().matrices.front().values.cwiseAbs().maxCoeff());
            const double part = steps.back().matrices.back().values(place_of(*effect_.dof), 0);
            sum.add(member.trace().member, std::abs(part) <= round_off * largest ? 0.0 : part);
        }
        sum.add("-F", -loads_on(node, load_case)[index(*effect_.dof)]);
        Step last{.kind = StepKind::Reaction, .node = node, .load_case = load_case, .matrices = {}};
        if (auto spring = spring_force(load_case, result)) last.matrices.push_back(std::move(*spring));
        last.matrices.push_back(sum.as(symbol()));
        if (const auto row = system_.row_of(node, *effect_.dof)) last.rows = {*row};
        steps.push_back(std::move(last));
        return steps;
    }

    /// Of all members that the number comes from, ascending.
    std::vector<Eigen::Index> rows_of_members() const
    {
        std::set<Eigen::Index> rows;
        for (const MemberSteps& member : members_)
            for (const Eigen::Index row : member.rows()) rows.insert(row);
        return {rows.begin(), rows.end()};
    }

    /// Directions in which the support of the node holds it and moves by itself.
    std::vector<Dof> moved_by_support(CaseId load_case) const
    {
        std::vector<Dof> dofs;
        for (const Dof dof : model_dofs(model_.analysis))
            if (!system_.row_of(*effect_.node, dof) && settlement_of(*effect_.node, dof, load_case) != 0.0)
                dofs.push_back(dof);
        return dofs;
    }

    /// The same force from the spring's own law, where the direction asked for is one of the support's.
    std::optional<NamedMatrix> spring_force(CaseId load_case, const CaseResult& result) const
    {
        const NodeId node = *effect_.node;
        const Dof dof = *effect_.dof;
        const double k = spring_at(node, dof);
        if (k == 0.0 || own_dofs().size() > 1) return std::nullopt;
        const double u = without_rounding(result.displacement(node)[index(dof)],
                                          result.magnitudes().displacement_of(dof)),
                     ground = settlement_of(node, dof, load_case);
        NamedMatrix matrix{"spring", {"k"}, {""}, {}};
        std::vector<double> values{k};
        if (ground != 0.0) {
            matrix.rows.emplace_back("ground");
            values.push_back(ground);
        }
        matrix.rows.insert(matrix.rows.end(), {"u", ground != 0.0 ? "k (ground - u)" : "-k u"});
        values.insert(values.end(), {u, k * (ground - u)});
        matrix.values = Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
        return matrix;
    }

    Eigen::Index place_of(Dof dof) const
    {
        return std::ranges::find(model_dofs(model_.analysis), dof) - model_dofs(model_.analysis).begin();
    }

    /// Of a node's own axes those that the displacement is made of.
    std::vector<Dof> own_dofs() const
    {
        const bool is_turned = system_.angle_of(*effect_.node) != 0.0 && !is_rotation(*effect_.dof);
        return is_turned ? std::vector{Dof::ux, Dof::uy} : std::vector{*effect_.dof};
    }

    std::vector<Step> displacement(CaseId load_case, const CaseResult& result, bool is_first) const
    {
        const NodeId node = *effect_.node;
        std::vector<Step> steps, from_rows;
        std::vector<Eigen::Index> rows;
        const bool has_ties = system_.trace().ties.has_value();
        for (const Dof dof : own_dofs())
            if (const auto row = system_.row_of(node, dof)) {
                if (is_first && !has_ties) steps.push_back(stiffness_row(*row));
                if (!has_ties) from_rows.push_back(load_row(*row, load_case, result));
                rows.push_back(*row);
            } else from_rows.push_back(held(dof, load_case, result));
        const SystemSteps system(system_, rows, about());
        if (is_first && !rows.empty()) append(steps, system.order());
        append(steps, std::move(from_rows));
        if (has_ties && !rows.empty()) append(steps, tied(system, rows, load_case, result));
        else if (!rows.empty()) steps.push_back(system.equations(load_case, result));
        if (own_dofs().size() > 1) steps.push_back(turned(load_case, result));
        return steps;
    }

    static std::vector<Step> tied(const SystemSteps& system, const std::vector<Eigen::Index>& rows, CaseId load_case,
                                  const CaseResult& result)
    {
        std::vector<Step> steps = system.solved(load_case, result);
        for (const Eigen::Index row : rows)
            if (auto one = system.tied_displacement(row, load_case, result)) steps.push_back(std::move(*one));
        return steps;
    }

    Step held(Dof dof, CaseId load_case, const CaseResult& result) const
    {
        const NodeId node = *effect_.node;
        const Eigen::VectorXd u = system_.in_node_axes(node, result.displacement(node));
        return {
            .kind = StepKind::Held,
            .node = node,
            .load_case = load_case,
            .matrices = {{"u", {model_[node].id + "." + std::string(name(dof))}, {"u"}, u.segment(place_of(dof), 1)}}};
    }

    /// From the axes of a turned support to the global one that is asked for.
    Step turned(CaseId load_case, const CaseResult& result) const
    {
        const NodeId node = *effect_.node;
        const Eigen::VectorXd own = system_.in_node_axes(node, result.displacement(node));
        Sum sum;
        for (const Dof dof : {Dof::ux, Dof::uy}) {
            Eigen::VectorXd alone = Eigen::VectorXd::Zero(own.size());
            alone[place_of(dof)] = own[place_of(dof)];
            sum.add(std::string(name(dof)) + "'", system_.in_global_axes(node, alone)[place_of(*effect_.dof)]);
        }
        return {.kind = StepKind::TurnedSupport, .node = node, .load_case = load_case, .matrices = {sum.as(symbol())}};
    }

    double spring_at(NodeId node, Dof dof) const
    {
        const Discretisation::SupportRow* support = system_.structure().support_of(node);
        return support == nullptr ? 0.0 : support->springs[index(dof)];
    }

    /// Row by row what the members that meet the node, and its spring, bring to K.
    Step stiffness_row(Eigen::Index row) const
    {
        const auto& [node, dof, end_of] = system_.trace().unknowns[static_cast<std::size_t>(row)];
        const std::vector<Eigen::Index> columns = system_.coupled_with(row);
        NamedMatrix shares{.symbol = "K", .rows = {}, .columns = {}, .values = {}};
        for (const Eigen::Index column : columns) shares.columns.push_back(system_.name_of(column));
        std::vector<Eigen::RowVectorXd> rows;
        for (const MemberSteps& member : members_) {
            const std::vector<int>& places = member.trace().equations;
            const Eigen::Index own = member.first_row(node) + place_of(dof);
            Eigen::RowVectorXd share = Eigen::RowVectorXd::Zero(static_cast<Eigen::Index>(columns.size()));
            for (std::size_t i = 0; i < places.size(); ++i) {
                const auto at = std::ranges::find(columns, Eigen::Index{places[i]} - 1);
                if (at != columns.end())
                    share[at - columns.begin()] += member.trace().global_stiffness(own, static_cast<Eigen::Index>(i));
            }
            rows.push_back(share);
            shares.rows.push_back(member.trace().member);
        }
        if (const double spring = spring_at(node, dof); spring > 0.0) {
            Eigen::RowVectorXd share = Eigen::RowVectorXd::Zero(static_cast<Eigen::Index>(columns.size()));
            share[std::ranges::find(columns, row) - columns.begin()] = spring;
            rows.push_back(share);
            shares.rows.emplace_back("spring");
        }
        shares.rows.push_back(system_.name_of(row));
        shares.values.resize(static_cast<Eigen::Index>(rows.size()) + 1, static_cast<Eigen::Index>(columns.size()));
        for (std::size_t i = 0; i < rows.size(); ++i) shares.values.row(static_cast<Eigen::Index>(i)) = rows[i];
        shares.values.bottomRows(1) = shares.values.topRows(static_cast<Eigen::Index>(rows.size())).colwise().sum();
        return {.kind = StepKind::StiffnessRow, .node = node, .matrices = {shares}, .rows = {row}};
    }

    /// Load on the node less what the members' loads take, and what imposed displacements bring.
    Step load_row(Eigen::Index row, CaseId load_case, const CaseResult& result) const
    {
        const auto& [node, dof, end_of] = system_.trace().unknowns[static_cast<std::size_t>(row)];
        Sum sum;
        sum.add("F", system_.in_node_axes(node, loads_on(node, load_case))[place_of(dof)]);
        for (const MemberSteps& member : members_) {
            const MemberTrace& trace = member.trace();
            const Eigen::Index own = member.first_row(node) + place_of(dof);
            sum.add("-f0 " + trace.member, -trace.fixed_end[load_case.index].global[own]);
            if (const double held = force_of_held(member, own, load_case, result); held != 0.0)
                sum.add("-k u " + trace.member, -held);
        }
        if (const double moved = ground_of(node, dof, load_case); moved != 0.0)
            sum.add("spring", spring_at(node, dof) * moved);
        return {
            .kind = StepKind::LoadRow, .node = node, .load_case = load_case, .matrices = {sum.as("f")}, .rows = {row}};
    }

    /// What displacements that supports impose bring to one row of a member.
    double force_of_held(const MemberSteps& member, Eigen::Index row, CaseId load_case, const CaseResult& result) const
    {
        const Step ends = member.end_displacements(load_case, result);
        double force = 0.0;
        for (std::size_t i = 0; i < member.trace().equations.size(); ++i)
            if (member.trace().equations[i] == 0) {
                const auto column = static_cast<Eigen::Index>(i);
                force += member.trace().global_stiffness(row, column) * ends.matrices[0].values(column, 0);
            }
        return force;
    }

    /// By how much the ground of a support or of its spring moves.
    double settlement_of(NodeId node, Dof dof, CaseId load_case) const
    {
        double moved = 0.0;
        for (const Settlement& settlement : model_.load_cases[load_case.index].settlements)
            if (settlement.node == node)
                for (const Component& component : settlement.components)
                    if (component.dof == dof) moved += component.value;
        return moved;
    }

    double ground_of(NodeId node, Dof dof, CaseId load_case) const
    {
        return spring_at(node, dof) == 0.0 ? 0.0 : settlement_of(node, dof, load_case);
    }

    const Model& model_;
    const Results& results_;
    const MovingEffect& effect_;
    PaperSystem system_;
    std::vector<MemberSteps> members_; ///< that the number comes from
};

/// Where the largest and the smallest value stand, and the larger of both as a section's value.
struct FoundExtreme {
    Step step;
    MovingEffect effect;
};

FoundExtreme extreme_of(const CaseResult& result, const MovingEffect& asked)
{
    const Curve curve = result.curve(*asked.member);
    const Extremes extremes = curve.extremes(*asked.component);
    const Extreme& found = std::abs(extremes.min.value) > std::abs(extremes.max.value) ? extremes.min : extremes.max;
    MovingEffect effect = influence::at_section(asked, found.x, curve.length());
    effect.at = Quantity(found.x, six_digits(found.x, english));
    const double after = curve.value(*asked.component, found.x, Side::After);
    const double before = curve.value(*asked.component, found.x, Side::Before);
    effect.side = std::abs(after - found.value) <= std::abs(before - found.value) ? Side::After : Side::Before;
    Eigen::Matrix2d places;
    places << extremes.max.x, extremes.max.value, extremes.min.x, extremes.min.value;
    return {{.kind = StepKind::Extreme,
             .member = asked.member,
             .matrices = {{"extremes", {"max", "min"}, {"x", "value"}, places}}},
            effect};
}

/// Of a section or a node both are its one value.
Extremes range_of(const CaseResult& result, const MovingEffect& effect)
{
    if (effect.quantity == ExpectedQuantity::Extreme) return result.curve(*effect.member).extremes(*effect.component);
    const double value = value_of(effect, result);
    return {{.value = value}, {.value = value}};
}

bool ends_with_sum(const Derivation& derivation)
{
    if (derivation.steps.empty()) return false; // a combination of nothing
    const StepKind last = derivation.steps.back().kind;
    return last != StepKind::Equations && last != StepKind::ReducedEquations && last != StepKind::Held;
}

/// Of a combination case by case. What is the same in all cases comes if it is the first of the derivation.
std::vector<Step> steps_of(const NumberSteps& number, const Model& model, CaseId load_case, bool is_first)
{
    std::vector<Step> steps;
    const CaseTerms terms = terms_of(model, load_case);
    for (const CaseTerms::Term& term : terms.terms)
        append(steps, number.steps(CaseId(term.load_case), is_first && &term == &terms.terms.front()));
    if (load_case.index >= model.load_cases.size()) steps.push_back(number.combination(terms));
    return steps;
}

/// R = sqrt(fx^2 + fy^2), from the steps of both components.
Derivation derive_resultant(const Model& model, const Results& results, CaseId load_case, const MovingEffect& resultant)
{
    MovingEffect fx = resultant, fy = resultant;
    fx.dof = Dof::ux;
    fy.dof = Dof::uy;
    Derivation derivation = derive(model, results, load_case, fx);
    std::vector<Step> along_y = steps_of(NumberSteps(model, results, fy), model, load_case, false);
    std::erase_if(along_y, [](const Step& step) { // the way there is that of fx
        return step.kind != StepKind::Reaction && step.kind != StepKind::Combination;
    });
    append(derivation.steps, std::move(along_y));
    const Eigen::Vector2d components(derivation.value, value_of(fy, results[load_case]));
    derivation.effect = resultant;
    derivation.value = components.norm();
    const std::string symbol = influence::effect_name(model, resultant);
    NamedMatrix sum{symbol, {influence::effect_name(model, fx), influence::effect_name(model, fy), symbol}, {""}, {}};
    sum.values = Eigen::Vector3d(components[0], components[1], derivation.value);
    derivation.steps.push_back({.kind = StepKind::Resultant, .node = resultant.node, .matrices = {std::move(sum)}});
    return derivation;
}

/// \param size       of the numbers whose round-off the difference may be
/// \param kept_case  where it is one of the model
Derivation less_kept(Derivation now, double kept, double size, std::optional<CaseId> kept_case, const Model& model)
{
    Sum sum;
    sum.add("now", now.value);
    sum.add("-kept", -kept);
    const std::string symbol = "Δ" + influence::effect_name(model, now.effect);
    now.value = without_rounding(now.value - kept, size);
    now.steps.push_back({.kind = StepKind::Difference,
                         .member = now.effect.member,
                         .node = now.effect.node,
                         .load_case = kept_case,
                         .matrices = {sum.as(symbol)}});
    return now;
}

} // namespace

Derivation derive(const Model& model, const Results& results, CaseId load_case, const MovingEffect& effect)
{
    if (is_resultant(effect)) return derive_resultant(model, results, load_case, effect);
    Derivation derivation{.effect = effect, .load_case = load_case, .steps = {}};
    if (effect.quantity == ExpectedQuantity::Extreme) {
        FoundExtreme found = extreme_of(results[load_case], effect);
        found.step.load_case = load_case;
        derivation.steps.push_back(std::move(found.step));
        derivation.effect = found.effect;
    }
    derivation.value = value_of(derivation.effect, results[load_case]);
    const NumberSteps number(model, results, derivation.effect);
    append(derivation.steps, steps_of(number, model, load_case, true));
    derivation.system = number.system();
    if (ends_with_sum(derivation))
        derivation.closing_error = std::abs(derivation.steps.back().matrices.back().values.bottomRows(1)(0, 0) -
                                            derivation.value);
    note_lost_digits(derivation.steps);
    return derivation;
}

Derivation derive_difference(const Model& model, const Results& results, CaseId now, CaseId kept,
                             const MovingEffect& effect)
{
    Derivation derivation = derive(model, results, now, effect);
    const NumberSteps number(model, results, derivation.effect);
    append(derivation.steps, steps_of(number, model, kept, false));
    note_lost_digits(derivation.steps);
    const double value = value_of(derivation.effect, results[kept]);
    const double size = std::max(size_of(derivation.effect, results[now]), size_of(derivation.effect, results[kept]));
    return less_kept(std::move(derivation), value, size, kept, model);
}

Derivation derive_difference(const Model& model, const Results& results, CaseId now, double kept,
                             const MovingEffect& effect)
{
    return less_kept(derive(model, results, now, effect), kept, size_of(effect, results[now]), std::nullopt, model);
}

Derivation derive_governing(const Model& model, const Results& results, const std::vector<CaseId>& cases,
                            const MovingEffect& effect)
{
    std::vector<double> largest, smallest;
    for (const CaseId id : cases) {
        const Extremes range = range_of(results[id], effect);
        largest.push_back(range.max.value);
        smallest.push_back(range.min.value);
    }
    const auto max = std::ranges::max_element(largest), min = std::ranges::min_element(smallest);
    const CaseId max_case = cases[static_cast<std::size_t>(max - largest.begin())];
    const CaseId min_case = cases[static_cast<std::size_t>(min - smallest.begin())];
    const CaseId governing = std::abs(*min) > std::abs(*max) ? min_case : max_case;
    Derivation derivation = derive(model, results, governing, effect);
    derivation.steps.insert(derivation.steps.begin(),
                            {.kind = StepKind::Governing,
                             .member = effect.member,
                             .node = effect.node,
                             .load_case = governing,
                             .matrices = {{"envelope",
                                           {model.case_name(max_case), model.case_name(min_case)},
                                           {"value"},
                                           Eigen::Vector2d(*max, *min)}}});
    return derivation;
}

} // namespace femoop::derivation
