#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "topology/meshing/mesh_domain.h"
#include "topology/meshing/size_field.h"

namespace topology {

/// How large elements are wanted, and of what shape.
struct MesherOptions {
    double size = 0.0;            ///< of edges far from the boundary; what the boundary has where 0
    double growth = usual_growth; ///< of edges by the distance from smaller ones
    double min_angle = 30.0;      ///< [degrees] that is asked for, at most 33
    int n_sweeps = 4;             ///< of smoothing
    std::vector<double> sizes{};  ///< wanted at nodes of the domain, where above 0; empty: what their edges have
    std::shared_ptr<const SizeField> field{}; ///< wanted everywhere besides; null: nothing

    /// A size at a place as far as `size` and the field allow it.
    double limited(double wanted, const FlatPoint& at) const;
};

/// What a mesher does in one step.
enum class MeshStep : std::uint8_t {
    Node,       ///< a node of the boundary stands
    Edge,       ///< an edge of the boundary is made
    Outside,    ///< triangles outside are taken away
    Point,      ///< a place inside was put into a poor triangle
    FrontPoint, ///< the shortest edge of the front got a triangle to a new place
    FrontNode,  ///< the shortest edge of the front got a triangle to a node that stands
    Quarter,    ///< a square of the tree was cut into four
    Pattern,    ///< a square inside was filled
    Band,       ///< triangles join the squares to the boundary
    Row,        ///< a row of cells was laid along the row before
    Triangles,  ///< the triangles stand that are to be paired
    Pair,       ///< two triangles became a quadrilateral
    Walk,       ///< a triangle that was left over met another
    Mend,       ///< all cells were looked at once, and smoothed
    Smoothed,   ///< all places inside were moved once
    Done
};

/// What a step is about, for those who look on.
struct MeshMarks {
    struct Circle {
        FlatPoint centre;
        double radius = 0.0;
    };
    std::vector<std::array<FlatPoint, 2>> lines; ///< the front; the squares of the tree
    std::vector<std::array<FlatPoint, 2>> edges; ///< that were chosen or made
    std::vector<FlatPoint> places;               ///< that were put in
    std::vector<std::vector<FlatPoint>> cells;   ///< that were made
    std::optional<Circle> circle;                ///< of the triangle that asked for a place
};

/// From a domain to cells, one step at a time. The nodes of the domain stay where they are, its edges are edges of cells.
class Mesher {
public:
    using Step = MeshStep;

    Mesher() = default;
    Mesher(const Mesher&) = delete;
    Mesher& operator=(const Mesher&) = delete;
    virtual ~Mesher() = default;

    virtual Step next() = 0;             ///< makes one step. \throws CrossingEdges
    virtual CellMesh mesh() const = 0;   ///< as it stands
    virtual MeshMarks marks() const = 0; ///< of the last step

    CellMesh run(const std::function<bool()>& is_cancelled = {}); ///< all steps; what there is, if it was cancelled
};

} // namespace topology
