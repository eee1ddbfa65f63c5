#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "apps/mohr/window/application.h"

namespace mohr {

/// What a scenario can expect of Mohr's circle, beside what it can expect of every app (ui/app/expectation.h):
///
///     state 50 MPa, -10 MPa, 40 MPa     the numbers as they are typed
///     principal 70 -30                  in space three
///     angle 20      normal 1 1 1        of the plane
///     factor 2.5                        of safety; `never`, `nothing`
///     remark Pure shear: ...            the first; `nothing`
///     step 5 of 10                      of the construction; `nothing`
///     verdicts right open open open     of an exercise's answers: open, right, follows, wrong; `nothing`
///     slip the sum is not halved        of the first wrong answer; `nothing`      points 3
///     notice nothing    file Untitled    changed no
///
/// Numbers have four digits. \returns what was found instead and what was wanted
std::optional<std::string> why_not(std::string_view expectation, const Application& application);

} // namespace mohr
