#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "femoop/solver/multifrontal/front_tree.h"
#include "femoop/solver/multifrontal/schedule.h"

namespace femoop {

inline std::size_t update_size(const FrontTree::Front& front) { return at(front.n_updated()) * at(front.n_updated()); }

/// Update matrices of a subtree wait for their parents on two stacks, by depth: a front takes its place on one while
/// its children's matrices lie on top of the other.
class Depths {
public:
    explicit Depths(const std::vector<FrontTree::Front>& fronts);
    std::size_t side(std::int32_t front) const { return is_odd_[at(front)] ? 1 : 0; }

private:
    std::vector<bool> is_odd_;
};

/// Does the update matrix of a front wait on a stack of its task? Else it is handed up to those who come after all
/// tasks.
inline bool waits_in_task(const FrontTree::Front& front, const Schedule::Task& task)
{
    return front.parent != FrontTree::none && task.contains(front.parent);
}

/// The most numbers that a factorization holds at a time, known before it takes any.
struct FrontMemory {
    std::array<std::size_t, 2> stacks{0, 0}; ///< of each member of the team
    std::size_t workspace = 0;               ///< of each member of the team
    std::size_t handed_up = 0;               ///< update matrices that are on no stack

    FrontMemory(const FrontTree& tree, const Schedule& schedule, const Depths& depths);
    /// With L, which stays, and the numbers of a right-hand side on its way.
    double bytes(const FrontTree& tree, int n_members) const;
};

} // namespace femoop
