#pragma once

#include "femoop/methods/cross/exercise/judge.h"
#include "ui/paint/painter.h"
#include "ui/paint/theme.h"

namespace cross {

/// The colour of what is said of a cell.
ui::Role role_of(femoop::cross::Verdict verdict);

/// What is said of a cell, for those who see no colours: a hook for right, a hook under a bar for right by the numbers
/// that were had, a cross for a mistake. \param em  its size
void draw_verdict(ui::Painter& painter, const ui::Theme& theme, femoop::cross::Verdict verdict, ui::Point middle,
                  double em);

} // namespace cross
