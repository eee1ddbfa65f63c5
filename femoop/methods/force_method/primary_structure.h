#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "femoop/model/fault/fault.h"
#include "femoop/model/model.h"

namespace femoop::force_method {

/// A force that equilibrium alone does not give: a reaction, along the axes of its own support, or a section force of a
/// member at a place. At a member's end it is the one between the end and its node, before what acts on the very end.
using Redundant = MovingEffect;

/// Where a redundant is released in the primary structure, and where it acts there as a load instead.
///
///      of a support        of a section, X on the member's end and -X on its node
///
///          |                  1            2         N  +x'  on end 2, -x' on end 1
///      ----o                ==|<-X    X->|==         V  -y'            +y'
///          ^ X                                       M  about +z'      about -z'
struct Release {
    NodeId node;
    std::optional<MemberId> member;                  ///< none: of the node's support
    std::size_t end = 0;                             ///< of the member
    Dof dof = Dof::ux;                               ///< in the axes of the support, or of the member
    Eigen::Vector3d axis = Eigen::Vector3d::UnitX(); ///< of the force or couple, global axes
    double flexibility = 0.0;                        ///< 1 / k of a spring that the force goes through; 0 without one
};

/// A structure with its redundants released, as a model of its own.
///
/// A member that is released inside is cut in two there, rigidly joined but for what is released
/// (femoop/edit/split.h).
struct PrimaryStructure {
    /// Of a member of the whole, from one place along it to another.
    struct Part {
        MemberId member; ///< of the primary structure
        double begin = 0.0, end = 0.0;
    };

    Model model; ///< its load cases are those of the whole, without settlements of what is released; nothing else loads
    std::vector<Release> releases;            ///< parallel to the redundants
    std::vector<std::vector<Part>> parts;     ///< of each member of the whole, from its first end on
    std::vector<std::vector<double>> imposed; ///< of every load case, for each release: its support's settlement
};

/// Blocked, or by a spring.
bool holds(const Support& support, Dof dof, AnalysisKind kind);
/// Which end of its member a section is at; none inside.
std::optional<std::size_t> end_at(double x, double length);

/// Everything that is wrong with these redundants: what is no force, what the structure does not carry there, what is
/// named twice. `place` is how faults name them, an option or a table.
std::vector<Fault> check_redundants(const Model& model, std::span<const Redundant> redundants,
                                    const std::string& place);

/// \pre check_redundants finds nothing. The primary structure may be able to move, which its analysis tells.
PrimaryStructure primary_structure(const Model& model, std::span<const Redundant> redundants);

/// The redundant as 1, and nothing else: on the support's node, or on both sides of the section.
LoadCase unit_state(const Model& primary, const Release& release, std::string id);

} // namespace femoop::force_method
