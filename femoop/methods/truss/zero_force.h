#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "femoop/methods/truss/truss.h"

namespace femoop::truss {

/// By which rule a bar is seen to carry nothing. Bars already found are no longer counted; a joint is unloaded where no
/// load and no reaction acts. Joints without a support are looked at first.
enum class ZeroForceRule : std::uint8_t {
    SingleBar,     ///< the only bar at an unloaded joint
    TwoBars,       ///< two bars at an unloaded joint, not in line: both
    ThirdBar,      ///< three bars at an unloaded joint, two in line: the third
    ForceAlongBar, ///< two bars, and the force acts along one of them: the other
    ForceInLine,   ///< three bars, two in line, and the force acts along these: the third
    NoRule         ///< under these loads, which only reckoning shows
};

struct ZeroForceBar {
    MemberId bar;
    ZeroForceRule rule = ZeroForceRule::NoRule;
    std::optional<NodeId> joint;     ///< where the rule is seen
    std::optional<MemberId> in_line; ///< the bar along which the force acts, or one of those in line
    std::vector<MemberId> without{}; ///< the bars at the joint that were found before, and count no longer
};

/// In the order in which they can be found: those that a rule shows, then the rest.
/// Source  [Kassimali, ch. 4]
std::vector<ZeroForceBar> zero_force_bars(const Truss& truss);

/// The same as a teacher steps through them: what is seen at one joint at once, and at last those that no rule shows.
std::vector<std::vector<ZeroForceBar>> zero_force_steps(const Truss& truss);

} // namespace femoop::truss
