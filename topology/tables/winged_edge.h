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
/// Source   L. F. Martha and A. M. A. Pereira, Geometric and Solid Modeling, lecture, planar subdivision
struct WingedTables {
    std::vector<TableRow> vertices, faces, edges;
};

/// `outside`, which the face around a planar subdivision may be, has number 0, the others then count from 1 without it.
WingedTables winged_tables(const Solid& solid, std::optional<FaceId> outside = std::nullopt);

/// As three tables under their headings, vertices with their places.
std::string winged_text(const Solid& solid, std::optional<FaceId> outside = std::nullopt);

} // namespace topology
