#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "femoop/model/ids.h"

namespace femoop::truss {

enum class RefusalKind : std::uint8_t {
    // of any method
    NotPlaneTruss,
    NoCase,
    Indeterminate, ///< `degree`
    // of the reciprocal diagram
    NoForce,        ///< nothing acts on the truss
    BarsCross,      ///< two of `bars`, `at` a place without a joint
    BarPassesJoint, ///< one of `bars`, one of `joints`
    FallsApart,     ///< `joints` of a part that no bar joins to the rest
    ForceInside,    ///< forces act at `joints` within the outline
    // of a section
    CutTooSmall,   ///< fewer than two bars
    CutNotThrough, ///< the truss hangs together without the `bars`
    CutAtOneSide,  ///< one of `bars` joins two joints of one part
    CutConcurrent  ///< no bar of the cut whose fellows all meet in one point
};

/// Why a method cannot be used, and the parts that are to blame. femoop/io/truss/truss_text.h has the sentence.
struct Refusal {
    RefusalKind kind = RefusalKind::NotPlaneTruss;
    std::vector<MemberId> bars;
    std::vector<NodeId> joints;
    std::optional<Eigen::Vector2d> at;
    int degree = 0;
};

} // namespace femoop::truss
