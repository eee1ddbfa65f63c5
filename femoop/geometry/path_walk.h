#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "femoop/model/fault/fault.h"
#include "femoop/model/model.h"

namespace femoop {

/// Members as a load passes them one after the other, as far as each begins at the node where the one before ended.
/// The first begins at the end that the second does not touch; its own direction holds where both would do.
struct PathWalk {
    std::vector<bool> is_reversed; ///< of each member that was passed: from its second node to its first
    std::size_t n_passed = 0;      ///< fewer than there are where the next one does not follow
};

/// \pre the members and their nodes are there
PathWalk walk(const Model& model, const std::vector<MemberId>& members);

/// Why members make no path: there are none, or two do not follow one another. \param place  as faults name it
std::optional<Fault> why_no_path(const Model& model, const std::vector<MemberId>& members, const std::string& place);

} // namespace femoop
