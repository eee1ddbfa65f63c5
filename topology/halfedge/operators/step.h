#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "topology/halfedge/entities.h"

namespace topology {

enum class OperatorKind : std::uint8_t {
    MVFS,
    KVFS,
    MEV,
    KEV,
    SEMV,
    JEKV,
    MVR,
    KVR,
    MEF,
    KEF,
    KEMR,
    MEKR,
    KFMRH,
    MFKRH,
    RINGMV,
    MOVE,
};
std::string_view name(OperatorKind kind); ///< "MEV"
OperatorKind inverse(OperatorKind kind);  ///< KEV of MEV; RINGMV and MOVE are their own

/// One applied operator: what it was given, and the few links that its inverse could not find again by itself.
/// What else the inverse needs stands in the rows of the dead, which keep their links.
struct Step {
    OperatorKind kind = OperatorKind::MVFS;
    std::uint8_t was_lone = 0;  ///< bit 0: `a` was or became a lone vertex's half-edge; bit 1: `b`
    std::uint8_t was_outer = 0; ///< MEKR: the killed loop was its face's outer one
    std::uint32_t a = 0,
                  b = 0;     ///< the half-edges, faces, loops or vertex that the operator was given, `b` 0 if only one
    std::uint32_t other = 0; ///< the new vertex of MVFS MEV SEMV MVR, the new face of MEF MFKRH, the new loop of KEMR;
                             ///< the killed loop of KEF and MEKR
    std::array<std::uint32_t, 4> old{}; ///< links before the step

    HalfEdgeId first() const { return HalfEdgeId{a}; }
    HalfEdgeId second() const { return HalfEdgeId{b}; }

    friend bool operator==(const Step&, const Step&) = default;
};

} // namespace topology
