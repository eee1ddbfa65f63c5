#pragma once

#include <cstdint>
#include <vector>

#include "femoop/model/fault/fault.h"
#include "femoop/model/model.h"

namespace femoop {

/// Parts of a model that its file's reader has already complained about. `check` says of such a part what is wrong with
/// the rest of it: not what it lacks, and nothing of a reference that leads nowhere or of a value that is no number.
struct Unreadable {
    bool header = false;        ///< the kind of analysis or the units: nothing can be checked
    bool is_incomplete = false; ///< something is missing, so that what remains may look unused
    std::vector<bool> materials, sections, nodes, members;
    std::vector<std::vector<bool>> node_loads, settlements, member_loads; ///< per load case
    std::vector<bool> combinations, expected, paths, influence_lines, trains, moving_envelopes;
    std::vector<bool> load_cases; ///< their ids alone
};

enum class Thoroughness : std::uint8_t {
    Errors,    ///< what keeps a model from being solved
    Everything ///< warnings too: unused parts, coincident nodes, crossings
};

/// `check`, for a model of which some parts could not be read.
std::vector<Fault> check_readable(const Model& model, const Unreadable& unreadable,
                                  Thoroughness thoroughness = Thoroughness::Everything);

} // namespace femoop
