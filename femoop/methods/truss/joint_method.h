#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "femoop/methods/truss/arrangement.h"
#include "femoop/methods/truss/section_method.h"
#include "femoop/methods/truss/truss.h"

namespace femoop::truss {

enum class StepKind : std::uint8_t {
    Joint,   ///< two equations find one or two bars
    Check,   ///< every bar at the joint is known: both equations have to hold
    Cut,     ///< no joint has fewer than three unknown bars: a section finds one
    Analysis ///< nor does a section: a complex truss, and one bar's force is the analysis'
};

/// A side of a joint's force polygon.
struct JointForce {
    std::optional<MemberId> bar;
    std::optional<std::size_t> force; ///< of Truss::forces
    Eigen::Vector2d away;             ///< unit: where it lies
    double value = 0.0;               ///< of a bar tension positive
    Eigen::Vector2d on_joint;
    bool is_found = false; ///< here
};

struct Step {
    StepKind kind = StepKind::Joint;
    std::optional<NodeId> joint;
    std::vector<JointForce> forces; ///< clockwise about the joint: one after the other they close
    std::vector<MemberId> found;
    std::optional<RitterCut> cut;
    double closing_error = 0.0;
};

struct JointMethod {
    std::vector<Step> steps;
    std::vector<double> forces; ///< of every bar, tension positive
};

/// Joint by joint, at each turn the leftmost that has at most two unknown bars. Reactions come from the equilibrium of
/// the whole, as the analysis has it.
/// Source  [TimoshenkoYoung1965, ch. 2]
/// Lesson  courseware/04-a-truss-by-three-methods.md
JointMethod joint_method(const Truss& truss, const Arrangement& arrangement);

} // namespace femoop::truss
