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
/// sways `stages` in place of `sheet`.
std::string sheet_json(const Worked& worked);

/// A row a line: stage, step, joint, then every end.
std::string sheet_csv(const Worked& worked);

} // namespace femoop::cross
