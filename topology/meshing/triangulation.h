#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "topology/geometry/flat_point.h"
#include "topology/meshing/mesh_domain.h"

namespace topology {

/// A constrained Delaunay triangulation: of all triangulations of its vertices with given edges the one with the
/// largest small angles. No vertex that can be seen from a triangle lies within its circle.
///
/// Corner   3 t + i is corner i of triangle t, and the edge opposite it; corners of a triangle run counter-clockwise
/// Vertices the first three stand far around all others and are of no mesh
/// Source   [Shewchuk1997] for predicates; insertion by the cavity of triangles whose circles hold the place
///          [Bowyer1981]; edges by flips [Sloan1993]
class Triangulation {
public:
    using Index = std::uint32_t;
    static constexpr Index none = std::numeric_limits<Index>::max();
    static constexpr Index n_frame_vertices = 3;

    explicit Triangulation(const FlatBox& box, std::size_t n_expected = 0); ///< \pre the box is not empty

    /// A place to be inserted: the triangles that have it in their circles, and the edges around them.
    struct Cavity {
        std::vector<Index> triangles;
        std::vector<Index> corners; ///< each the edge of a triangle inside, seen from it
        double nearest = 0.0;       ///< distance to the nearest vertex around, squared
    };
    /// \param start  a triangle to walk from
    /// Nothing where an edge that is fixed, or a vertex, is in the way.
    const Cavity* cavity(const FlatPoint& at, Index start);
    /// The vertex that stands there now, of the last cavity.
    Index insert(const FlatPoint& at);

    /// Makes an edge between two vertices and fixes it. The two ends of what is in the way: an edge that is fixed, or
    /// twice a vertex on the line.
    std::optional<std::array<Index, 2>> fix(Index a, Index b);

    void release(Index a, Index b); ///< the edge is fixed no longer. \pre it is there

    /// The triangle of the edge from a to b that lies to its left.
    std::optional<Index> triangle_left_of(Index a, Index b) const;

    std::size_t n_vertices() const { return points_.size(); }
    std::size_t n_triangles() const { return triangles_.size(); }
    const FlatPoint& at(Index vertex) const { return points_[vertex]; }
    Index vertex(Index corner) const { return triangles_[corner / 3].vertices[corner % 3]; }
    const std::array<Index, 3>& vertices(Index triangle) const { return triangles_[triangle].vertices; }
    /// The same edge from the other side; nothing at the frame.
    Index twin(Index corner) const { return triangles_[corner / 3].twins[corner % 3]; }
    Index corner_of(Index vertex) const { return corners_[vertex]; } ///< one of those that are there
    bool is_fixed(Index corner) const { return (triangles_[corner / 3].fixed >> (corner % 3) & 1U) != 0; }
    bool is_frame(Index vertex) const { return vertex < n_frame_vertices; }
    static Index next(Index corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
    static Index previous(Index corner) { return corner % 3 == 0 ? corner + 2 : corner - 1; }
    /// The next corner of the same vertex, clockwise; nothing at the frame.
    Index turned(Index corner) const
    {
        const Index across = twin(next(corner));
        return across == none ? none : next(across);
    }

    /// Moves a vertex; `restore` makes the triangulation Delaunay again. \pre all its triangles stay counter-clockwise
    void move(Index vertex, const FlatPoint& to) { points_[vertex] = to; }
    /// Flips edges until every one that is not fixed is Delaunay.
    void restore();

private:
    struct Triangle {
        std::array<Index, 3> vertices{};
        std::array<Index, 3> twins{none, none, none};
        std::uint8_t fixed = 0; ///< a bit for each edge
    };

    Index locate(const FlatPoint& at, Index start) const;
    bool gather(const FlatPoint& at, Index start);
    void link(Index corner, Index other);
    void set_fixed(Index corner);
    std::optional<Index> edge_between(Index a, Index b) const;
    Index flip(Index corner);
    bool is_convex(Index corner) const;
    bool is_illegal(Index corner) const;
    std::optional<std::array<Index, 2>> crossings(Index a, Index b, std::vector<CellEdge>& found) const;
    void legalize(std::vector<Index> corners);

    std::vector<FlatPoint> points_;
    std::vector<Triangle> triangles_;
    std::vector<Index> corners_;      ///< of each vertex
    std::vector<std::uint32_t> seen_; ///< of each triangle: the search that came by
    std::uint32_t search_ = 0;
    Cavity cavity_;
    std::vector<Index> fan_; ///< of each vertex: scratch
};

} // namespace topology
