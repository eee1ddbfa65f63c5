#pragma once

#include <optional>
#include <variant>

#include "femoop/plane/model/ids.h"
#include "topology/geometry/flat_point.h"

namespace plane {

using femoop::MaterialId;
using femoop::NodeId;
using femoop::plane::CurveId;
using femoop::plane::RegionId;
using topology::FlatPoint;

/// A face of the drawing, by a place in it.
struct FacePlace {
    FlatPoint at;
    friend bool operator==(const FacePlace&, const FacePlace&) = default;
};

/// What can be selected.
using Part = std::variant<NodeId, CurveId, FacePlace>;

} // namespace plane
