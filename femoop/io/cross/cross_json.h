#pragma once

#include <string>

#include "femoop/methods/cross/comparison.h"
#include "femoop/methods/cross/superposition.h"

namespace femoop::cross {

/// A structure distributed, and what it is compared with.
struct Worked {
    const Model& model;
    const Problem& problem;
    const Procedure& procedure;
    const Superposition& all;
    const Comparison& comparison;
};

/// The shape of a `cross` block: `factors`, `fixed_end_moments`, `sheet` and `final`; and what else was found. With
/// sways `stages` in place of `sheet`; by symmetry `half` before each sheet, which has the ends of that half alone.
std::string sheet_json(const Worked& worked);

/// A row a line: stage, step, joint, then every end; of a half the ends on its sheet, and in the totals all.
std::string sheet_csv(const Worked& worked);

} // namespace femoop::cross
