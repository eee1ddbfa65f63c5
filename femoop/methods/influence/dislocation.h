#pragma once

#include <array>

#include "femoop/methods/influence/member_motion.h"
#include "femoop/model/dof.h"
#include "femoop/model/expected.h"

namespace femoop::influence {

/// A member whose part beyond a section is moved by 1 against the other, in the positive direction of a section force:
///
///      N   apart along x'               V   a step along -y', Vz along -z'
///      M   a kink that opens the        T   a twist about x'
///          -y' side, My the -z' side
///
///           x
///      1 o------+  +-----------o 2      the forces of the one part on the other do no work on anything else, so that
///               |<1>                    the path moves by the force's influence line
///
/// A bar, which carries what stands between its nodes as a simple beam, moves by itself alone in V and M.
///
/// Assumes  no constraint takes from the member what the section force strains
/// Source   Mueller-Breslau's principle [Kassimali, ch. 8]
/// Lesson   courseware/03-influence-lines.md
class Dislocation {
public:
    Dislocation(const Discretisation& structure, MemberId member, MemberComponent force, double x);

    /// A load as the sum of its doubles and what these leave of 32 digits.
    struct NodeLoad {
        NodeVector high{}, low{};
    };
    /// Loads on its two nodes that move the rest of the structure as the dislocation does, global axes. Those of a short
    /// member are large beside what they do, and what rounding would leave of their sum moves long chains.
    const std::array<NodeLoad, 2>& node_loads() const { return node_loads_; }

    /// The member's own motion when its nodes move its ends, inside their joints, so far if nothing else moved them.
    MemberMotion motion(std::array<LocalDisplacement, 2> ends) const;

private:
    /// What the part beyond the section is moved by, in one plane.
    struct Step {
        double v = 0.0, phi = 0.0;
    };
    struct PlaneMotion {
        double from, to;
        Polynomial v, phi;
    };
    using PlaneEnds = Eigen::Vector4d; ///< v1, phi1, v2, phi2

    bool is_at_start() const { return x_ == 0.0; }
    bool is_at_end() const { return x_ == L_; }
    bool is_simple(BendingPlane plane) const;
    Step step(BendingPlane plane) const;
    PlaneEnds rigid_ends(BendingPlane plane) const;
    std::vector<SpanLoad> held_back(BendingPlane plane) const;
    double gap() const { return force_ == MemberComponent::N ? 1.0 : 0.0; }
    double twist() const { return force_ == MemberComponent::T ? 1.0 : 0.0; }
    std::array<NodeVector, 2> fixed_end_forces() const;
    PlaneEnds end_forces(BendingPlane plane) const;
    void follow_joints(const Discretisation& structure, MemberId member);
    NodeVector second_node_moved(const MemberGeometry& geometry, const Eigen::Vector3d& arm) const;
    std::vector<PlaneMotion> motion(BendingPlane plane, const PlaneEnds& ends) const;
    std::vector<PlaneMotion> simple_beam(BendingPlane plane, const PlaneEnds& ends) const;
    std::vector<PlaneMotion> elastic_beam(BendingPlane plane, const PlaneEnds& ends) const;
    std::vector<PlaneMotion> on_foundation(BendingPlane plane, const PlaneEnds& ends) const;
    std::vector<PlaneMotion> from_state(const Beam& beam, const Beam::State& begin, BendingPlane plane) const;

    AnalysisKind kind_;
    MemberComponent force_;
    double x_, L_;
    bool is_bar_;
    Bar axial_, torsion_;
    Beam xy_, xz_;
    std::array<NodeLoad, 2> node_loads_{}; ///< global axes
    std::array<NodeVector, 2> slips_{};    ///< of its ends in flexible joints while its nodes are held, member axes
};

} // namespace femoop::influence
