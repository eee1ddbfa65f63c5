#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "apps/euler/window/application.h"

namespace euler {

/// What a scenario can expect of the stepper, sentences in English whatever language the app speaks, beside what it can
/// expect of every app (ui/app/expectation.h):
///
///     counts 8 12 6 6 1 0       V E F L S G of all solids together
///     place 3 of 12             the steps that are done
///     step MEF                  the operator that is looked at, or `nothing`
///     deltas 0 +1 +1 +1 0 0     what it changes
///     valid yes                 every link of every solid is sound
///     selection face f1         or `nothing`
///     table loops               the table that is seen below
///     asked the new face's name what the operator asks for next; `nothing` where none does
///     verdict Right: it was MEV.   hint look among the loops   points 3   of a challenge
///     fault line 2: v9 is not there   why what was written last into the script was not taken; `nothing`
///     notice nothing     file cube.eul     changed no
///
/// \returns what was found instead and what was wanted
std::optional<std::string> why_not(std::string_view expectation, Application& application);

} // namespace euler
