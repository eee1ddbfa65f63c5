#pragma once

#include <cstddef>

#include "femoop/analysis/solver_trace.h"
#include "ui/paint/painter.h"
#include "ui/paint/theme.h"
#include "ui/text/catalogue.h"

namespace frame {

/// Which step of which walk is drawn, and how.
struct SolverLook {
    ui::Theme theme;
    ui::Catalogue tr; ///< language of the words
    femoop::Ordering ordering = femoop::Ordering::NestedDissection;
    std::size_t step = 0; ///< front, from 0; the last one where it is beyond
};

/// Draws a step of elimination on the painter's whole sheet, four pictures that belong together: the front on the
/// structure with the separators of dissection, the elimination tree, the matrix of the front, and the pattern of L in
/// four orders with what each costs. They stand in a row where the sheet is broad, else in two.
///
/// Nodes and entries that mean different things differ in shape too, not in colour alone. Of a system that is too large
/// to be shown, or has no unknowns, it says so.
///
/// Lesson  courseware/02-the-front-walks.md
void draw_solver(ui::Painter& painter, const femoop::SolverTrace& trace, const SolverLook& look);

} // namespace frame
