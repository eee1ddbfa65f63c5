#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "femoop/element/continuum/continuum_load.h"
#include "femoop/plane/mesh/mesh_geometry.h"
#include "femoop/plane/model/plane_load.h"

namespace femoop::plane {

FieldPlace place_of(const Eigen::Vector2d& at);
double value_or_zero(const std::optional<Field>& field, const FieldPlace& at);

/// A load of a curve as an edge of an element feels it: force per area along the global axes.
/// \pre what it points to outlives it
struct EdgeTraction {
    const CurveLoad* load;
    const CurveGeometry* curve;
    std::size_t edge; ///< of the curve
    bool is_reversed; ///< the element's edge runs against the curve
    double per_area;  ///< what a force per length is multiplied by

    Eigen::Vector2d operator()(const EdgePoint& point) const;
    /// Where tables of the load have a row within the edge, so that it is smooth only between these: natural
    /// coordinates of the element's edge, ascending.
    std::vector<double> kinks() const;

private:
    FieldPlace place(double xi) const; ///< of the element's edge
};

} // namespace femoop::plane
