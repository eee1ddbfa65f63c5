#pragma once

#include <vector>

#include "femoop/methods/derivation/derivation.h"

namespace femoop::derivation {

/// Where the terms of a product nearly cancel, as in EA/L (u2' - u1') of ends that move together, its factors need more
/// digits than its result: notes in `more_digits` how many, so that with the numbers as they are written the products
/// k' u', k u and T u come to what is written of them.
void note_lost_digits(std::vector<Step>& steps);

} // namespace femoop::derivation
