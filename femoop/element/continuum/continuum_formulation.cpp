#include "femoop/element/continuum/continuum_formulation.h"

#include <stdexcept>
#include <string>
#include <utility>

namespace femoop {

namespace {

/// Of an integrand on a straight-sided element: load 4, function 2, area 1, radius 1.
constexpr int load_degree = 8;

void require(bool holds, const char* what)
{
    if (!holds) throw std::invalid_argument(std::string("ContinuumFormulation: ") + what);
}

} // namespace

std::vector<ShapeAtPoint> tabulated(const Shape& shape, const IntegrationRule& rule)
{
    std::vector<ShapeAtPoint> table;
    for (const auto& [at, weight] : rule.points)
        table.push_back({.at = at, .N = shape.values(at), .dN = shape.derivatives(at), .weight = weight});
    return table;
}

IntegrationRule standard_rule(ShapeKind kind, StressState state)
{
    const Shape& shape = shape_of(kind);
    if (shape.domain() == Domain::Line) return gauss_line(shape.degree());
    if (shape.domain() == Domain::Quadrilateral) return gauss_quadrilateral(shape.degree() + 1);
    const bool is_axisymmetric = state == StressState::Axisymmetric;
    if (shape.degree() == 1) return symmetric_triangle(is_axisymmetric ? 3 : 1);
    return symmetric_triangle(is_axisymmetric ? 6 : 3);
}

const GeometryCheck& GeometryChecks::of(ShapeKind shape)
{
    auto known = checks_.find(shape);
    if (known == checks_.end())
        known = checks_.emplace(shape, GeometryCheck(shape_of(shape), standard_rule(shape, state_))).first;
    return known->second;
}

ContinuumFormulation::ContinuumFormulation(const Shape& shape, IntegrationRule rule, const ConstitutiveModel& material,
                                           double thickness, ElementVariant variant, double density)
    : shape_(shape),
      material_(material),
      rule_(std::move(rule)),
      thickness_(thickness),
      variant_(variant),
      density_(density),
      geometry_check_(shape, rule_)
{
    require(shape.edge_kind().has_value(), "the shape is a line, which has no area");
    require(rule_.domain == shape.domain(), "the integration rule is of another domain than the shape");
    require(material.state() != StressState::Solid, "a plane shape cannot have the stresses of a solid");
    require(thickness > 0.0, "the thickness is not positive");
    const StressState without = variant == ElementVariant::MeanDilatation ? StressState::PlaneStress
                                                                          : StressState::Axisymmetric;
    require(variant == ElementVariant::Standard || (shape.kind() == ShapeKind::Q4 && material.state() != without),
            "no such variant of this shape in this stress state");
    points_ = tabulated(shape, rule_);
    load_points_ = tabulated(shape, rule_of_degree(shape.domain(), load_degree));
    edge_points_ = tabulated(shape_of(*shape.edge_kind()), rule_of_degree(Domain::Line, load_degree));
}

} // namespace femoop
