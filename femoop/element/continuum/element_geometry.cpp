#include "femoop/element/continuum/element_geometry.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace femoop {

namespace {

constexpr double area_rounding = 64.0 * std::numeric_limits<double>::epsilon();

/// det J, and zero where it is no more than what area_rounding leaves of it.
double area_ratio(const Eigen::Matrix2d& J)
{
    const double area = J.determinant();
    if (std::abs(area) > area_rounding * J.row(0).lpNorm<1>() * J.row(1).lpNorm<1>()) return area; // without roots
    return std::abs(area) <= area_rounding * J.row(0).norm() * J.row(1).norm() ? 0.0 : area;
}

} // namespace

Eigen::Matrix2d jacobian(const Shape::Derivatives& derivatives, const NodePositions& positions)
{
    // From the first node, so that nothing is lost far from the origin.
    Eigen::Matrix2d J = Eigen::Matrix2d::Zero();
    for (Eigen::Index i = 1; i < positions.rows(); ++i)
        J += derivatives.row(i).transpose() * (positions.row(i) - positions.row(0));
    return J;
}

GeometryCheck::GeometryCheck(const Shape& shape, const IntegrationRule& rule) : shape_(shape)
{
    for (int i = 0; const NaturalPoint at : shape.nodes().first(static_cast<std::size_t>(shape.n_corners())))
        places_.push_back({.at = at, .dN = shape.derivatives(at), .corner = i++});
    for (const IntegrationPoint& point : rule.points)
        places_.push_back({.at = point.at, .dN = shape.derivatives(point.at)});
}

std::optional<GeometryFault> GeometryCheck::fault(const NodePositions& positions) const
{
    if (positions.rows() != shape_.n_nodes())
        return GeometryFault{.flaw = GeometryFlaw::WrongNodeCount,
                             .shape = shape_.kind(),
                             .value = static_cast<double>(positions.rows())};
    GeometryFault least{.shape = shape_.kind(), .value = std::numeric_limits<double>::infinity()};
    double largest = -std::numeric_limits<double>::infinity();
    for (const Place& place : places_) {
        const double area = area_ratio(jacobian(place.dN, positions));
        if (!(area >= least.value)) least.value = area, least.at = place.at, least.node = place.corner;
        largest = std::max(largest, area);
    }
    if (least.value > 0.0) return std::nullopt;
    least.flaw = largest > 0.0 ? GeometryFlaw::Distorted : GeometryFlaw::Clockwise;
    if (largest == 0.0 && least.value == 0.0) least.flaw = GeometryFlaw::NoArea;
    return least;
}

std::optional<GeometryFault> why_not_element(const Shape& shape, const IntegrationRule& rule,
                                             const NodePositions& positions)
{
    return GeometryCheck(shape, rule).fault(positions);
}

std::optional<GeometryFault> why_not_axisymmetric(const Shape& shape, const NodePositions& positions)
{
    Eigen::Index node = 0;
    const double least = positions.col(0).minCoeff(&node);
    if (least >= 0.0) return std::nullopt;
    return GeometryFault{
        .flaw = GeometryFlaw::LeftOfAxis, .shape = shape.kind(), .value = least, .node = static_cast<int>(node)};
}

std::string message(const GeometryFault& fault)
{
    std::ostringstream text;
    const std::string_view shape = name(fault.shape);
    switch (fault.flaw) {
    case GeometryFlaw::WrongNodeCount:
        text << "a " << shape << " has " << shape_of(fault.shape).n_nodes() << " nodes, not " << fault.value;
        break;
    case GeometryFlaw::NoArea:
        text << "the nodes of this " << shape << " lie in one line, so that it has no area; move a node out of it";
        break;
    case GeometryFlaw::Clockwise:
        text << "the nodes of this " << shape << " run clockwise; list them counter-clockwise";
        break;
    case GeometryFlaw::Distorted:
        text << "this " << shape << " is too distorted: its Jacobian is " << fault.value << " at ";
        if (fault.node) text << "node " << *fault.node + 1;
        else text << "xi = " << fault.at.xi << ", eta = " << fault.at.eta;
        text << " and must be positive; keep its corners convex and middle nodes near mid-side";
        break;
    case GeometryFlaw::LeftOfAxis:
        text << "node " << *fault.node + 1 << " of this " << shape << " has the radius " << fault.value
             << "; a body of revolution lies at x >= 0";
        break;
    }
    return text.str();
}

} // namespace femoop
