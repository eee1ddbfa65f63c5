#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "apps/cross/window/application.h"

namespace cross {

/// What a scenario can expect of moment distribution, beside what it can expect of every app (ui/app/expectation.h):
///
///     step 3           how many turns are done          turns C B all
///     branches 2       ways gone so far                 sheet 1        0: the loads, then the sways, then all
///     total BA -86.5   the sum of a column              balanced yes
///     at rest yes      nothing turns
///     cell factor BA right               what is said of a pupil's cell (cell_names.h), open, or not judged
///     score 3          cells right without help    solved no
///     exercise nothing or its name                 typing nothing, or what the cell asks
///     hint nothing, or the last one of the cell
///     notice nothing   file Untitled   changed no       undo Put a support
///     zoom 1.2
///
/// Numbers have four digits, in the file's units. \returns what was found instead and what was wanted
std::optional<std::string> why_not(std::string_view expectation, const Application& application);

} // namespace cross
