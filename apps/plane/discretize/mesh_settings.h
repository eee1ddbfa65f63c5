#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "apps/plane/discretize/face_outline.h"
#include "topology/meshing/mapped_mesher.h"
#include "topology/meshing/size_field.h"

namespace discretize {

/// How a region is meshed: its own wishes over the model's, and what is usual where neither says.
struct MeshSettings {
    std::string method = "auto";
    femoop::ShapeKind element = femoop::ShapeKind::T6;
    double size = 0.0;       ///< of edges
    double min_angle = 30.0; ///< [degrees]
    topology::Diagonal diagonal = topology::Diagonal::Right;
    std::vector<femoop::NodeId> corners; ///< of a mapped region
    /// In place of all that the drawing says of sizes, of divisions and of points too; what is not asked to be mapped is
    /// meshed freely then. Null: as the drawing says.
    std::shared_ptr<const topology::SizeField> field{};

    /// The method maps a region from its corners, which it has so many of.
    bool is_map() const { return method == "mapped" || method == "sweep" || is_trilateral(); }
    bool is_trilateral() const { return method == "trilateral"; }
    std::size_t n_corners() const { return is_trilateral() ? 3 : 4; }
    bool is_triangle() const { return femoop::is_triangle(element); }
    bool is_quadratic() const { return element != femoop::ShapeKind::T3 && element != femoop::ShapeKind::Q4; }
};

/// Of each outline. \param field  null: sizes are the drawing's own
std::vector<MeshSettings> settings_of(const Drawing& drawing, const std::vector<FaceOutline>& outlines,
                                      const std::shared_ptr<const topology::SizeField>& field = {});

} // namespace discretize
