#include "femoop/methods/mohr/point_results.h"

#include <numbers>

namespace femoop::mohr {

namespace {

void add_plane(PointResults& results, const PointQuestion& question)
{
    results.plane = plane(question.state);
    results.turned = rotated(results.plane, question.angle);
    results.circle = circle(results.plane);
    results.principal = principal(results.plane);
    if (const auto first = results.principal.angle)
        results.second_angle = as_direction(*first + 0.5 * std::numbers::pi);
    results.shear_angle = largest_shear_angle(results.plane);
    results.pole_of_planes = pole(results.plane, question.rule);
    results.pole_of_normals = pole(results.plane, question.rule, PoleOf::Normals);
}

void add_space(PointResults& results, const PointQuestion& question)
{
    results.space = in_space(question.state);
    if (!results.space) return;
    results.space_principal = principal(*results.space);
    results.absolute_shear = absolute_largest_shear(results.space_principal);
    results.deviator = deviator(results.space_principal);
    results.invariants = invariants(*results.space);
    results.on_plane = on_plane(*results.space, question.normal);
}

/// Solved in the unit of the strains and then counted in that of E, so that no rounding comes between equal values.
void add_stress(PointResults& results, const PointQuestion& question)
{
    if (!is_strain(question.state.kind)) return;
    const auto found = stress(question.state);
    if (!found) return;
    const double u = question.strain_unit;
    results.stress = SpaceState{u * found->x, u * found->y, u * found->z, u * found->xy, u * found->yz, u * found->zx};
    results.principal_stress = principal(*found);
    for (double& value : results.principal_stress->values) value *= u;
}

} // namespace

ShearRule usual_rule(Kind kind) { return kind == Kind::Inertia ? ShearRule::TensorDown : ShearRule::ClockwiseUp; }

PointResults point_results(const PointQuestion& question)
{
    PointResults results;
    add_plane(results, question);
    add_space(results, question);
    add_stress(results, question);
    if (!question.criterion) return results;
    const SpacePrincipal& judged = results.principal_stress ? *results.principal_stress : results.space_principal;
    results.safety = safety(*question.criterion, question.strength, judged);
    return results;
}

} // namespace femoop::mohr
