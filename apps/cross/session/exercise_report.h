#pragma once

#include "apps/cross/session/report.h"

namespace cross {

/// What a pupil wrote and what is said of it: cell, number, judgement. \pre the session has a paper
tabular::Table exercise_table(const Session& session);

/// The same as lines of text, with the score.
std::string exercise_description(const Session& session);

/// "12 of 34 cells, 10 right the first time"
std::string score_text(const Session& session);

/// "Exercise 3.17: overhang, several EI", or that it is a structure of one's own.
std::string exercise_name(const Session& session);

} // namespace cross
