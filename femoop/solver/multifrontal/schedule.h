#pragma once

#include <cstdint>
#include <vector>

#include "femoop/solver/multifrontal/front_tree.h"

namespace femoop {

/// Who eliminates what: subtrees, which need nothing from one another, and the fronts above them, which all work on
/// together. What is computed does not depend on it.
struct Schedule {
    /// Whole subtrees that follow one another in postorder.
    struct Task {
        std::int32_t first; ///< front
        std::int32_t end;
        bool contains(std::int32_t front) const { return first <= front && front < end; }
    };
    std::vector<Task> tasks;
    std::vector<std::int32_t> top; ///< fronts, in postorder

    /// With one worker a single task.
    Schedule(const FrontTree& tree, int n_workers);
};

} // namespace femoop
