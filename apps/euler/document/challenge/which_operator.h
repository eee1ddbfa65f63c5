#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "apps/euler/document/stepper.h"

namespace euler {

/// "Which operator was applied?" A lesson at two places, one step apart, and four names to choose from. Going back a
/// step asks for the inverse. What is shown of the step's report would give the answer away.
struct WhichOperator {
    Stepper lesson;
    std::size_t before = 0, after = 0; ///< places
    std::vector<std::string> choices;  ///< "MEV"
    std::size_t answer = 0;            ///< among the choices
    ui::Message hint;                  ///< how the counts change
};
WhichOperator which_operator(std::uint32_t seed);

} // namespace euler
