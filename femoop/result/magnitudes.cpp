#include "femoop/result/magnitudes.h"

#include <algorithm>
#include <cmath>

#include "femoop/discretisation/solution.h"
#include "femoop/result/components.h"
#include "femoop/result/curve_reader.h"
#include "femoop/result/results.h"

namespace femoop {

namespace {

void see(double& largest, double value)
{
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
}

void see(Magnitudes& most, const Curve& curve, AnalysisKind kind)
{
    for (const MemberComponent component : member_components(kind)) {
        double& largest = is_displacement(component) ? most.displacement
                          : is_moment(component)     ? most.moment
                                                     : most.force;
        const Extremes extremes = curve.extremes(component);
        see(largest, extremes.max.value);
        see(largest, extremes.min.value);
    }
}

/// What temperature and misfit would do to members that cannot give way, and to those that are free.
void see_strains(Magnitudes& most, const Discretisation& structure, const CaseLoads& loads, double factor)
{
    for (std::size_t i = 0; i < structure.members.size(); ++i)
        for (const SpanLoad& load : loads.of(MemberId(i))) {
            if (load.kind != SpanLoad::Kind::Strain) continue;
            const MemberProperties& properties = structure.properties_of(MemberId(i));
            see(most.force, factor * properties.axial.EA * load.start);
            see(most.moment, factor * properties.xy.EI * load.end);
            const double L = structure.geometry(MemberId(i)).length;
            see(most.displacement, factor * load.start * L);
            see(most.displacement, factor * load.end * L * L);
        }
}

void see_nodes(Magnitudes& most, const CaseLoads& loads, double factor)
{
    for (const CaseLoads::OnNode& load : loads.nodes)
        for (const Dof dof : all_dofs)
            see(is_rotation(dof) ? most.moment : most.force, factor * load.value[index(dof)]);
}

} // namespace

double Magnitudes::of(MemberComponent component) const
{
    if (is_displacement(component)) return displacement;
    return is_moment(component) ? moment : force;
}

double without_rounding(double value, double magnitude)
{
    constexpr double round_off = 1.0e-12;
    return std::abs(value) < round_off * magnitude ? 0.0 : value;
}

Magnitudes CaseResult::magnitudes() const
{
    const Discretisation& structure = *solution_->structure;
    Magnitudes most;
    CurveReader reader(*this);
    for (std::size_t i = 0; i < structure.members.size(); ++i) see(most, reader.read(MemberId(i)), structure.kind);
    for (std::size_t i = 0; i < structure.positions.size(); ++i) {
        const NodeVector u = displacement(NodeId(i));
        for (const Dof dof : all_dofs) see(is_rotation(dof) ? most.rotation : most.displacement, u[index(dof)]);
    }
    for (const Discretisation::SupportRow& support : structure.supports) { // what stands on one passes no member
        const NodeVector r = reaction(support.node);
        for (const Dof dof : all_dofs) see(is_rotation(dof) ? most.moment : most.force, r[index(dof)]);
    }
    for (const CaseTerms::Term& term : solution_->cases[index_].terms) {
        see_nodes(most, solution_->loads[term.load_case], term.factor);
        see_strains(most, structure, solution_->loads[term.load_case], term.factor);
    }
    const double size = structure.size();
    if (size == 0.0) return most;
    most.moment = std::max(most.moment, most.force * size);
    most.force = std::max(most.force, most.moment / size);
    most.displacement = std::max(most.displacement, most.rotation * size);
    most.rotation = std::max(most.rotation, most.displacement / size);
    return most;
}

} // namespace femoop
