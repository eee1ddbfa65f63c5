#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "femoop/methods/truss/refusal.h"
#include "femoop/model/model.h"
#include "femoop/result/results.h"

namespace femoop::truss {

/// Of the two joints of a member, in its order.
struct Bar {
    std::array<NodeId, 2> joints;
    Eigen::Vector2d direction; ///< unit, from the first to the second
    double force = 0.0;        ///< by the analysis, tension positive; where loads act along it the mean of both ends
};

enum class ForceCause : std::uint8_t { Load, Reaction };

/// A force on a joint from outside that is not zero. All loads on a joint count as one.
struct ExternalForce {
    NodeId joint;
    ForceCause cause = ForceCause::Load;
    Eigen::Vector2d force; ///< on the joint, global axes
};

/// A plane truss under one load case as the hand methods see it: joints, bars, and the forces on the joints from outside.
/// Loads on bars are carried to the joints, as by simple beams; along a bar half to each.
///
/// Signs    forces in global axes; bars positive in tension
/// Units    the model's base units
/// Accuracy forces below 1e-9 of the largest are 0
struct Truss {
    std::vector<Eigen::Vector2d> joints; ///< of every node
    std::vector<Bar> bars;               ///< of every member
    std::vector<ExternalForce> forces;   ///< in the order of the nodes, loads before reactions
    std::vector<std::vector<MemberId>> bars_at;
    std::vector<bool> is_supported; ///< of every joint, though its reaction may be 0
    bool has_loaded_bars = false;
    double largest_force = 0.0;

    const Bar& operator[](MemberId bar) const { return bars[bar.index]; }
    NodeId other_joint(MemberId bar, NodeId joint) const;
    Eigen::Vector2d away_from(NodeId joint, MemberId bar) const;                 ///< along the bar, unit
    Eigen::Vector2d force_at(NodeId joint) const;                                ///< sum of the forces from outside
    bool is_zero(double force) const;                                            ///< beside the largest
    bool are_parallel(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const; ///< of any lengths
};

/// The same in other units: every length times this, every force times that.
Truss scaled(Truss truss, double length, double force);

/// Why statics alone does not give its forces, if so: no plane truss, no load case, or statically indeterminate.
std::optional<Refusal> why_no_truss(const Model& model, const Results& results);

/// \param results  of the model \pre why_no_truss says nothing
Truss truss_of(const Model& model, const Results& results, CaseId load_case);

} // namespace femoop::truss
