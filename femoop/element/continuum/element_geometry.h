#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "femoop/rule/integration_rule.h"
#include "femoop/shape/shape.h"

namespace femoop {

/// Where an element's nodes lie, one a row.
using NodePositions = Eigen::Matrix<double, Eigen::Dynamic, 2, 0, Shape::max_nodes, 2>;

/// J = d(x, y) / d(xi, eta): row xi, row eta. det J is how much area of the drawing a natural area becomes.
Eigen::Matrix2d jacobian(const Shape::Derivatives& derivatives, const NodePositions& positions);

/// What is wrong with the place of an element's nodes.
enum class GeometryFlaw : std::uint8_t {
    WrongNodeCount, ///< `value` nodes where the shape has others
    NoArea,         ///< all nodes lie in one line or in one place
    Clockwise,      ///< det J is negative everywhere
    Distorted,      ///< det J is positive in some places only
    LeftOfAxis      ///< of a body of revolution: a node has the radius `value` < 0
};

struct GeometryFault {
    GeometryFlaw flaw = GeometryFlaw::NoArea;
    ShapeKind shape = ShapeKind::T3;
    double value = 0.0;        ///< the least det J, or what the flaw says
    NaturalPoint at{};         ///< where det J is least (Distorted)
    std::optional<int> node{}; ///< counted from 0: at that place, or with that radius
};

/// Why nodes there make no element: its map must keep areas positive at corners and at integration points. Tabulated
/// for the many elements that have one shape and one rule.
class GeometryCheck {
public:
    GeometryCheck(const Shape& shape, const IntegrationRule& rule);
    std::optional<GeometryFault> fault(const NodePositions& positions) const;

private:
    struct Place {
        NaturalPoint at;
        Shape::Derivatives dN;
        std::optional<int> corner{};
    };
    const Shape& shape_;
    std::vector<Place> places_;
};

/// The same of a single element.
std::optional<GeometryFault> why_not_element(const Shape& shape, const IntegrationRule& rule,
                                             const NodePositions& positions);
std::optional<GeometryFault> why_not_axisymmetric(const Shape& shape, const NodePositions& positions);

/// English: `the nodes of this Q4 run clockwise; list them counter-clockwise`.
std::string message(const GeometryFault& fault);

} // namespace femoop
