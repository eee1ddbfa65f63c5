#pragma once

#include <array>
#include <string>
#include <vector>

#include "femoop/model/fault/fault.h"
#include "femoop/plane/model/plane_model.h"
#include "topology/geometry/curve.h"

namespace discretize {

using femoop::plane::PlaneModel;

/// A part of a drawn curve from vertex to vertex, as it was drawn, with its ends as they were given.
struct ShapePart {
    topology::Curve curve;
    std::array<topology::FlatPoint, 2> ends;
};

topology::FlatPoint place_of(const PlaneModel& model, const femoop::plane::DrawnPlace& drawn);

/// What a drawn curve is made of, in its direction: straight parts, arcs, Bezier cubics. Or what is wrong with it.
/// Source  splines: [DeBoor1978, ch. IV]
struct ShapeCurves {
    std::vector<ShapePart> parts;
    std::vector<femoop::Fault> faults;
};

/// \param place  what faults name it by  \pre `check(model)` finds no error
ShapeCurves curves_of(const PlaneModel& model, const femoop::plane::DrawnShape& shape, const std::string& place,
                      double snap);

} // namespace discretize
