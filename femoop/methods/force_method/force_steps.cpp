#include "femoop/methods/force_method/force_steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "femoop/methods/influence/effect_name.h"
#include "femoop/result/components.h"

namespace femoop::force_method {

namespace {

using derivation::NamedMatrix;
using derivation::Step;
using derivation::StepKind;
using virtual_work::Work;

constexpr double round_off = 1e-12;                         ///< of the largest force of its kind in any state
constexpr std::array<double, 3> percents{0.0, 50.0, 100.0}; ///< of a member's length, where it is read

/// Forces of one kind: the section forces of one component, or all reactions.
struct Forces {
    std::string symbol;
    std::vector<std::string> places;
    Eigen::MatrixXd values; ///< [places x states]; the last column is the sum

    bool is_nothing(const Eigen::VectorXd& X) const
    {
        Eigen::RowVectorXd largest = values.cwiseAbs().colwise().maxCoeff();
        for (Eigen::Index i = 0; i < X.size(); ++i) largest[i + 1] *= std::abs(X[i]);
        return largest.maxCoeff() == 0.0;
    }
};

/// Reads the states of a method.
class States {
public:
    explicit States(const ForceMethod& method) : method_(method), primary_(method.primary.model) {}

    std::vector<Forces> forces() const
    {
        std::vector<Forces> all;
        for (const MemberComponent component : section_force_components(primary_.analysis))
            all.push_back(section_forces(component));
        all.push_back(reactions());
        silence_round_off(all);
        std::erase_if(all, [&](const Forces& one) { return one.values.size() == 0 || one.is_nothing(method_.X); });
        return all;
    }

private:
    std::size_t n_states() const { return method_.cases.size() + 1; }
    CaseResult result(std::size_t state) const
    {
        return state < method_.cases.size() ? method_.state(state) : method_.sum();
    }

    Forces section_forces(MemberComponent component) const
    {
        Forces forces{std::string(name(component, primary_.analysis)), {}, {}};
        std::vector<std::size_t> n_places;
        for (std::size_t m = 0; m < primary_.members.size(); ++m) {
            const std::string& id = primary_.members[m].id;
            n_places.push_back(is_read_once(MemberId(m)) ? 1 : percents.size());
            if (n_places.back() == 1) forces.places.push_back(id);
            else
                for (const double percent : percents)
                    forces.places.push_back(id + ", " + std::to_string(std::lround(percent)) + "%");
        }
        forces.values.resize(rows(forces), static_cast<Eigen::Index>(n_states()));
        for (std::size_t state = 0; state < n_states(); ++state) {
            Eigen::Index row = 0;
            for (std::size_t m = 0; m < primary_.members.size(); ++m) {
                const Curve curve = result(state).curve(MemberId(m));
                for (std::size_t i = 0; i < n_places[m]; ++i)
                    forces.values(row++, static_cast<Eigen::Index>(state)) = value(curve, component, percents.at(i));
            }
        }
        return forces;
    }

    static double value(const Curve& curve, MemberComponent component, double percent)
    {
        const Side side = percent == 100.0 ? Side::Before : Side::After;
        const double x = percent == 100.0 ? curve.length() : percent / 100.0 * curve.length();
        return curve.value(component, x, side);
    }

    /// A bar of a truss has one axial force, unless a load along it stands between its ends.
    bool is_read_once(MemberId member) const
    {
        if (!is_truss(primary_.analysis)) return false;
        for (std::size_t state = 0; state < n_states(); ++state) {
            const Curve curve = result(state).curve(member);
            const double first = value(curve, MemberComponent::N, percents.front());
            for (const double percent : percents)
                if (std::abs(value(curve, MemberComponent::N, percent) - first) > round_off * std::abs(first))
                    return false;
        }
        return true;
    }

    static Eigen::Index rows(const Forces& forces) { return static_cast<Eigen::Index>(forces.places.size()); }

    /// In a state, with what stands for the supports that were released.
    double reaction(std::size_t state, NodeId node, Dof dof) const
    {
        const CaseResult result = this->result(state);
        double value = result.is_supported(node) ? result.reaction(node)[index(dof)] : 0.0;
        for (std::size_t i = 0; i < method_.n_redundants(); ++i) {
            const Release& release = method_.primary.releases[i];
            if (release.member || release.node != node || is_rotation(release.dof) != is_rotation(dof)) continue;
            const double part = release.axis[static_cast<Eigen::Index>(index(dof) % 3)];
            if (state == i + 1) value += part;
            if (state + 1 == n_states()) value += method_.X[static_cast<Eigen::Index>(i)] * part;
        }
        return value;
    }

    bool is_supported(NodeId node) const
    {
        const auto is_of_it = [&](const Release& one) { return !one.member && one.node == node; };
        return primary_[node].support || std::ranges::any_of(method_.primary.releases, is_of_it);
    }

    Forces reactions() const
    {
        Forces forces{"R", {}, {}};
        std::vector<std::pair<NodeId, Dof>> rows;
        for (std::size_t n = 0; n < primary_.nodes.size(); ++n)
            for (const Dof dof : dof_list(primary_.analysis))
                if (is_supported(NodeId(n))) rows.emplace_back(NodeId(n), dof);
        for (const auto& [node, dof] : rows)
            forces.places.push_back(primary_[node].id + "." + std::string(force_name(dof)));
        forces.values.resize(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(n_states()));
        for (std::size_t i = 0; i < rows.size(); ++i)
            for (std::size_t state = 0; state < n_states(); ++state)
                forces.values(static_cast<Eigen::Index>(i),
                              static_cast<Eigen::Index>(state)) = reaction(state, rows[i].first, rows[i].second);
        return forces;
    }

    /// Beside the largest force of a state a number that is no more than its rounding is 0.
    void silence_round_off(std::vector<Forces>& all) const
    {
        for (std::size_t state = 0; state < n_states(); ++state) {
            const auto column = static_cast<Eigen::Index>(state);
            double largest = 0.0;
            for (const Forces& one : all)
                if (one.values.size() > 0) largest = std::max(largest, one.values.col(column).cwiseAbs().maxCoeff());
            for (Forces& one : all)
                one.values.col(column) =
                    (one.values.col(column).array().abs() <= round_off * largest).select(0.0, one.values.col(column));
        }
    }

    const ForceMethod& method_;
    const Model& primary_;
};

std::string state_name(const std::string& symbol, std::size_t state) { return symbol + std::to_string(state); }

/// Forces of one state: a column for each section force, reactions beside.
Step state_step(const std::vector<Forces>& all, std::size_t state)
{
    Step step{.kind = StepKind::State, .state = state};
    NamedMatrix sections{state_name("S", state), {}, {}, {}};
    const auto column = static_cast<Eigen::Index>(state);
    for (const Forces& one : all) {
        if (one.symbol == "R") continue;
        sections.rows = one.places;
        sections.columns.push_back(one.symbol);
        sections.values.conservativeResize(one.values.rows(), sections.values.cols() + 1);
        sections.values.rightCols(1) = one.values.col(column);
    }
    if (!sections.columns.empty()) step.matrices.push_back(std::move(sections));
    for (const Forces& one : all)
        if (one.symbol == "R")
            step.matrices.push_back({state_name("R", state), one.places, {""}, one.values.col(column)});
    return step;
}

Step superposition(const std::vector<Forces>& all, const ForceMethod& method, const std::vector<std::string>& names)
{
    Step step{.kind = StepKind::StateSuperposition};
    for (const Forces& one : all) {
        NamedMatrix sum{one.symbol, one.places, {state_name(one.symbol, 0)}, one.values};
        for (std::size_t i = 1; i <= method.n_redundants(); ++i) {
            sum.columns.push_back(redundant_name(i) + " " + state_name(one.symbol, i));
            sum.values.col(static_cast<Eigen::Index>(i)) *= method.X[static_cast<Eigen::Index>(i) - 1];
        }
        sum.columns.push_back(one.symbol);
        step.matrices.push_back(std::move(sum));
    }
    Eigen::MatrixXd both(method.X.size(), 2);
    both << method.X, method.analysed;
    step.matrices.push_back({"X", names, {"X", "K u = f"}, std::move(both)});
    return step;
}

Step redundants_step(const ForceMethod& method, const std::vector<std::string>& names)
{
    Step step{.kind = StepKind::Redundants};
    Eigen::MatrixXd given(method.X.size(), 2);
    for (Eigen::Index i = 0; i < given.rows(); ++i)
        given.row(i) << method.imposed[i], method.primary.releases[static_cast<std::size_t>(i)].flexibility;
    step.matrices.push_back({"X", names, {"c", "1/k"}, std::move(given)});
    if (method.degree.has_foundation) return step; // no number says it
    const Eigen::Vector2d degrees(method.degree.total(), method.states.indeterminacy().total());
    step.matrices.push_back({"n", {"n", "n0"}, {""}, degrees});
    return step;
}

/// The parts that work in any state on the forces of one, member by member.
Step flexibility_step(const ForceMethod& method, std::size_t i)
{
    const Model& primary = method.primary.model;
    const std::vector<Work>& work = method.work[i];
    const std::string row = std::to_string(i + 1);
    NamedMatrix gaps{"δ", {}, {}, {}};
    for (std::size_t j = 0; j < work.size(); ++j) gaps.columns.push_back("δ" + row + std::to_string(j));
    std::vector<Eigen::RowVectorXd> parts;
    const auto add = [&](const std::string& name, const Eigen::RowVectorXd& values) {
        if (values.isZero(0.0)) return;
        gaps.rows.push_back(name);
        parts.push_back(values);
    };
    const auto n = static_cast<Eigen::Index>(work.size());
    for (std::size_t m = 0; m < primary.members.size(); ++m) {
        Eigen::RowVectorXd values(n);
        for (Eigen::Index j = 0; j < n; ++j) values[j] = work[static_cast<std::size_t>(j)].of(MemberId(m));
        add(primary.members[m].id, values);
    }
    std::set<std::pair<std::uint32_t, Dof>> supports;
    for (const Work& one : work)
        for (const virtual_work::SupportWork& support : one.supports)
            supports.insert({support.node.index, support.dof});
    for (const auto& at : supports) {
        Eigen::RowVectorXd values = Eigen::RowVectorXd::Zero(n);
        for (Eigen::Index j = 0; j < n; ++j)
            for (const virtual_work::SupportWork& one : work[static_cast<std::size_t>(j)].supports)
                if (std::pair(one.node.index, one.dof) == at) values[j] += one.value;
        add(primary.nodes[at.first].id + "." + std::string(femoop::name(at.second)), values);
    }
    Eigen::RowVectorXd spring = Eigen::RowVectorXd::Zero(n);
    spring[static_cast<Eigen::Index>(i) + 1] = method.primary.releases[i].flexibility;
    add("1/k", spring);
    gaps.rows.emplace_back("sum");
    gaps.values.resize(static_cast<Eigen::Index>(parts.size()) + 1, n);
    for (std::size_t k = 0; k < parts.size(); ++k) gaps.values.row(static_cast<Eigen::Index>(k)) = parts[k];
    gaps.values.bottomRows(1) << method.delta_0[static_cast<Eigen::Index>(i)],
        method.delta.row(static_cast<Eigen::Index>(i));
    return {.kind = StepKind::Flexibility, .matrices = {std::move(gaps)}, .state = i + 1};
}

Step equations_step(const ForceMethod& method)
{
    std::vector<std::string> X, equations;
    for (std::size_t i = 1; i <= method.n_redundants(); ++i) {
        X.push_back(redundant_name(i));
        equations.push_back(std::to_string(i));
    }
    return {.kind = StepKind::RedundantEquations,
            .matrices = {{"δ", equations, X, method.delta},
                         {"X", X, {""}, method.X},
                         {"c - δ0", equations, {""}, method.imposed - method.delta_0}},
            .is_whole = true};
}

} // namespace

std::string redundant_name(std::size_t number) { return "X" + std::to_string(number); }

derivation::Derivation steps(const ForceMethod& method, const Model& model)
{
    std::vector<std::string> names;
    for (const Redundant& one : method.redundants)
        names.push_back(redundant_name(names.size() + 1) + " = " + influence::effect_name(model, one));
    const std::vector<Forces> forces = States(method).forces();
    derivation::Derivation way{.effect = method.redundants.front(),
                               .load_case = method.load_case,
                               .value = method.X[0],
                               .steps = {redundants_step(method, names)},
                               .redundants = method.redundants};
    for (std::size_t state = 0; state < method.cases.size(); ++state) way.steps.push_back(state_step(forces, state));
    for (std::size_t i = 0; i < method.n_redundants(); ++i) way.steps.push_back(flexibility_step(method, i));
    way.steps.push_back(equations_step(method));
    way.steps.push_back(superposition(forces, method, names));
    return way;
}

} // namespace femoop::force_method
