#pragma once

#include <optional>
#include <string>
#include <vector>

#include "topology/tables/entity_tables.h"

namespace topology {

/// The same solid as a winged-edge structure, which has no half-edges: its edges carry all the links.
///
///     eLN |       | eRP
///         |  vF   |          vI, vF      the vertices where the edge begins and ends
///         +---o---+          fL, fR      the faces on its left and right, seen from outside
///             ^              eLP, eLN    the edges before and after it around the left face,
///         fL  |  fR          eRP, eRN    and around the right one, each with its face on the left
///             |
///         +---o---+          A vertex and a face name one of their edges, eI.
///         |  vI   |
///     eLP |       | eRN
///
/// The edge runs as its plus half does, so fL is the face of that half. What it cannot say: a ring, and a lone vertex.
/// A face's row has one eI for each loop here, which the structure has not.
/// Source   [MarthaPereira], planar subdivision
///
/// `outside`, which the face around a planar subdivision may be, has number 0, the others then count from 1 without it.
/// Rows are made when they are asked for.
class WingedTables {
public:
    WingedTables() = default; ///< of no solid: no rows
    /// The solid must outlive the tables.
    explicit WingedTables(const Solid& solid, std::optional<FaceId> outside = std::nullopt);

    std::size_t n_vertices() const { return vertices_.size(); }
    std::size_t n_faces() const { return faces_.size(); }
    std::size_t n_edges() const { return edges_.size(); }
    TableRow vertex(std::size_t row) const; ///< \pre row < n_vertices(), likewise of the others
    TableRow face(std::size_t row) const;
    TableRow edge(std::size_t row) const;
    std::size_t most_loops() const { return most_loops_; } ///< of a face

private:
    std::size_t number(FaceId f) const;
    TableCell face_cell(std::string_view label, HalfEdgeId h) const;
    TableCell edge_cell(std::string_view label, HalfEdgeId h) const;

    const Solid* solid_ = nullptr;
    std::optional<FaceId> outside_;
    std::vector<VertexId> vertices_;
    std::vector<FaceId> faces_;
    std::vector<EdgeId> edges_;
    std::size_t most_loops_ = 0;
};

/// As three tables under their headings, vertices with their places.
std::string winged_text(const Solid& solid, std::optional<FaceId> outside = std::nullopt);

} // namespace topology
