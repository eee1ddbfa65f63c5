#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "femoop/model/dof.h"
#include "femoop/model/ids.h"
#include "femoop/model/node.h"
#include "femoop/model/quantity/quantity.h"

namespace femoop {

/// How a member's end is joined to its node. Releases and springs name the member's own axes and sit at the
/// end of the flexible part, inside the offset.
struct MemberEnd {
    DofSet release;               ///< the force of these degrees of freedom is zero
    std::vector<Spring> springs;  ///< semi-rigid joint; none on a released degree of freedom
    std::vector<Quantity> offset; ///< rigid arm from the node to the end, global axes: empty, or 2 or 3 lengths

    friend bool operator==(const MemberEnd&, const MemberEnd&) = default;
};

enum class BeamTheory : std::uint8_t { EulerBernoulli, Timoshenko };

/// A straight member from its first node to its second, prismatic unless it has depths. Its axes: x' along it; in 2D y' is x' turned
/// +90 degrees; in 3D y' is the part of `up` square to x' (default +z, +y for a vertical member), z' = x' x y'.
struct Member {
    std::string id;
    std::array<NodeId, 2> nodes;
    std::optional<MaterialId> material; ///< needed unless rigid
    std::optional<SectionId> section;   ///< needed unless rigid
    std::vector<Quantity> depths; ///< tapered: h at its first end and at its second, linear between; empty, or two
    MemberEnd start, end;
    BeamTheory theory = BeamTheory::EulerBernoulli;
    bool inextensible = false;
    bool unshearable = false;
    bool rigid = false;
    bool bar = false; ///< axial force only
    bool tension_only = false;
    bool compression_only = false;
    std::optional<Quantity> foundation; ///< Winkler modulus along y', both ways [force/length^2]
    std::vector<Quantity> up;           ///< 3D only: empty, or three numbers

    friend bool operator==(const Member&, const Member&) = default;
};

} // namespace femoop
