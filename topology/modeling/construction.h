#pragma once

#include <vector>

#include "topology/halfedge/operators/euler_operator.h"

namespace topology {

/// How a solid can be made: a solid like it, with the journal of the operators that make it from nothing. That one can
/// be found for every solid proves that the operators are complete.
///
/// Found by inversion, a copy being reduced to nothing: (1) MEKR of every ring, (2) KEF of every edge between two
/// faces, (3) KEV of every edge between two vertices, which leaves each shell one vertex, one face and two closed edges
/// a handle; (4) for each handle KEMR, MFKRH and KEF; (5) KVFS. The inverses in the opposite order make the solid. With
/// R = L - F rings there are S MVFS, V - S MEV, F - S + G MEF, G KFMRH, and R - G more KEMR than MEKR.
///
/// Source   [Mantyla1988, ch. 9], the completeness of the operators
struct Construction {
    Solid solid;
    Journal journal;
    std::vector<VertexId> vertex_of; ///< by index: the vertex of the original
    std::vector<FaceId> face_of;     ///< by index: the face of the original, `nothing` of one that only helped
};

Construction construction(const Solid& original);

} // namespace topology
