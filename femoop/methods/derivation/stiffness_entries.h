#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "femoop/element/member_properties.h"
#include "femoop/model/dof.h"

namespace femoop::derivation {

struct NamedNumber {
    std::string name;
    double value;
};

/// What a member's own stiffness k' is made of.
struct StiffMember {
    AnalysisKind kind = AnalysisKind::Frame2d;
    const MemberProperties* properties = nullptr;
    std::array<JointStiffness, 2> joints{rigid_joints, rigid_joints};
    double length = 0.0;
    bool stretches = true;               ///< else its axial part is in no stiffness
    bool bends = true;                   ///< else it is a bar
    bool is_on_foundation_alone = false; ///< rigid: its foundation is all that is left
    /// "A.rz'" of the first end's rotation: what stands beside a row of k'.
    std::function<std::string(std::size_t end, LocalAxis axis)> row_name;
};

/// The formulas with the member's numbers: each entry of k' is one of them, but for its sign, or 0.
///
/// An end on a rotational spring k has the fixity factor r = 1/(1 + 3 EI/(L k)), 1 where it is rigid and 0 at a hinge:
///
///     k'11 = 12 EI (r1 + r2 + r1 r2)/(L^3 D)      k'12 = 6 EI r1 (2 + r2)/(L^2 D)
///     k'22 = 12 EI r1/(L D)                       k'25 = 6 EI r1 r2/(L D)             D = 4 - r1 r2
///
/// which is 12 EI/L^3, 6 EI/L^2, 4 EI/L, 2 EI/L of rigid ends and 3 EI/L^3, 3 EI/L^2, 3 EI/L of one hinge. Shear, and
/// springs across the axis, add to phi = 12 EI/L^3 (L/GAs + 1/k1 + 1/k2), a taper makes flexibilities integrals. On a
/// foundation they are Hetenyi's; with joints, or where it shears too, no such formula is usual: then none is given.
///
/// Source  flexibilities in series [Przemieniecki1968, sec. 6.6]; foundation [Hetenyi1946]; both by hand from these
std::vector<NamedNumber> stiffness_entries(const StiffMember& member);

} // namespace femoop::derivation
