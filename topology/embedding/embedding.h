#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "topology/halfedge/operators/refusal.h"
#include "topology/halfedge/solid.h"

namespace topology {

/// What is wrong with the places of a solid's vertices, while its structure is sound. The sentence of each stands in
/// embedding.cpp.
enum class EmbeddingFault : std::uint8_t {
    ZeroLengthEdge,  ///< {0}
    NoArea,          ///< the outer loop of face {0} encloses nothing
    NotPlanar,       ///< face {0}, by its vertex {1}
    RingTurned,      ///< ring {0} of face {1} runs as the outer loop does
    RingOutside,     ///< ring {0} of face {1} is not inside its outer loop
    EdgesMeet,       ///< {0} and {1} of one face, elsewhere than at a common end
    VertexOnFace,    ///< {0} touches the inside of face {1}
    EdgeThroughFace, ///< {0} pierces face {1}
    InsideOut,       ///< the shell of face {0}, which lies in no other, has its outside inside
};
inline constexpr int n_embedding_faults = 9;

struct EmbeddingFinding {
    EmbeddingFault fault = EmbeddingFault::ZeroLengthEdge;
    std::array<Entity, 2> entities{};

    friend bool operator==(const EmbeddingFinding&, const EmbeddingFinding&) = default;
};
std::string_view pattern(EmbeddingFault fault); ///< English, with places {0} {1}
std::string sentence(const EmbeddingFinding& finding, const EntityName& name = table_name);

/// Looks at the geometry of a sound solid with straight edges; empty where it bounds what it seems to bound. A face
/// that is found to be of no area or in no plane is not looked at further, and a lone vertex as a ring need only lie
/// inside. An outer loop tells by itself which way its face looks, so that it is counter-clockwise; whether the faces
/// of a shell look outward is seen from the shell's volume.
///
/// Misses   faces that touch with their edges alone, and a shell that is turned while it lies within another's box
/// Accuracy distances up to 1e-9 of the solid's extent are none
/// Cost     the edges times the faces whose boxes they meet
std::vector<EmbeddingFinding> embedding_faults(const Solid& solid);

} // namespace topology
