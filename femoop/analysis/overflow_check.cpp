#include "femoop/analysis/overflow_check.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "femoop/result/components.h"
#include "femoop/result/curve_reader.h"

namespace femoop {

namespace {

constexpr double harmless = 1e40; // a product of six such numbers is still within the range

/// The largest of what it is shown.
class Largest {
public:
    void see(double value) { value_ = std::max(value_, std::abs(value)); }
    void see(const Eigen::Vector3d& vector) { see(vector.cwiseAbs().maxCoeff()); }
    bool is_harmless() const { return value_ < harmless; }

private:
    double value_ = 0.0;
};

void see(Largest& largest, const MemberProperties& properties)
{
    for (const double value : {properties.axial.EA, properties.torsion.EA, properties.xy.EI, properties.xz.EI,
                               properties.xy.foundation, properties.xy.shear_flexibility})
        largest.see(value);
}

/// May products of stiffnesses, lengths, displacements, loads and factors overflow?
bool may_overflow(const detail::Solution& solution)
{
    const Discretisation& structure = *solution.structure;
    Largest largest;
    for (const Eigen::Vector3d& position : structure.positions) largest.see(position);
    for (const MemberProperties& properties : structure.properties) see(largest, properties);
    for (const Discretisation::SupportRow& support : structure.supports)
        for (const double spring : support.springs) largest.see(spring);
    for (std::size_t i = 0; i < structure.members.size(); ++i) {
        const MemberEndConditions* end_conditions = structure.end_conditions_of(MemberId(i));
        const auto& nodes = structure.members[i].nodes;
        const double length = end_conditions != nullptr && end_conditions->has_offset
                                  ? structure.geometry(MemberId(i)).length
                                  : (structure.positions[nodes[1].index] - structure.positions[nodes[0].index]).norm();
        largest.see(1.0 / length);
    }
    for (const detail::CaseSolution& each : solution.solutions) {
        for (const double u : each.displacements) largest.see(u);
        for (const double u : each.constraint_displacements) largest.see(u);
    }
    for (const CaseLoads& loads : solution.loads)
        for (const SpanLoad& load : loads.span_loads) {
            largest.see(load.start);
            largest.see(load.end);
        }
    for (const CaseTerms& terms : solution.cases)
        for (const CaseTerms::Term& term : terms.terms) largest.see(term.factor);
    return !largest.is_harmless();
}

bool is_in_range(const NodeVector& vector)
{
    return std::all_of(vector.begin(), vector.end(), [](double x) { return std::abs(x) < largest_number; });
}

bool is_in_range(const Curve& curve, AnalysisKind kind)
{
    const auto is_fine = [](double value) { return std::abs(value) < largest_number; };
    const std::vector<MemberComponent> components = member_components(kind);
    return std::all_of(components.begin(), components.end(), [&](MemberComponent component) {
        const auto [max, min] = curve.extremes(component);
        const double middle = curve.value(component, 0.5 * curve.length());
        return is_fine(max.value) && is_fine(min.value) && is_fine(middle);
    });
}

bool is_in_range(const CaseResult& result, const Results& results)
{
    for (std::size_t i = 0; i < results.n_nodes(); ++i) {
        if (!is_in_range(result.displacement(NodeId(i)))) return false;
        if (result.is_supported(NodeId(i)) && !is_in_range(result.reaction(NodeId(i)))) return false;
    }
    CurveReader reader(result);
    for (std::size_t i = 0; i < results.n_members(); ++i)
        if (!is_in_range(reader.read(MemberId(i)), results.analysis())) return false;
    const Equilibrium sums = result.equilibrium();
    return is_in_range(sums.sum_loads) && is_in_range(sums.sum_reactions);
}

} // namespace

std::vector<Fault> overflowing_cases(const detail::Solution& solution, const Results& results)
{
    std::vector<Fault> faults;
    if (!may_overflow(solution)) return faults;
    for (std::size_t c = 0; c < results.n_cases(); ++c)
        if (const CaseResult result = results[CaseId(c)]; !is_in_range(result, results))
            faults.push_back({.kind = FaultKind::ResultsBeyondRange, .arguments = {result.name()}});
    return faults;
}

std::optional<Fault> huge_displacement(const Model& model, const Discretisation& structure, const Results& results,
                                       double most)
{
    const double limit = most * structure.size();
    for (std::size_t c = 0; c < model.load_cases.size(); ++c) {
        const CaseResult result = results[CaseId(c)];
        for (std::size_t i = 0; i < structure.positions.size(); ++i) {
            const NodeVector u = result.displacement(NodeId(i));
            const double distance = std::hypot(u[0], u[1], u[2]);
            if (distance <= limit) continue;
            std::ostringstream text;
            text << std::setprecision(3) << distance << ' ' << name(model.units.length);
            return Fault{.kind = FaultKind::HugeDisplacement,
                         .arguments = {model.nodes[i].id, text.str(), model.load_cases[c].id}};
        }
    }
    return std::nullopt;
}

} // namespace femoop
