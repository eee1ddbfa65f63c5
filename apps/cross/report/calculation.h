#pragma once

#include "apps/cross/document/solution.h"
#include "apps/cross/view/look.h"
#include "ui/paint/text_measure.h"
#include "ui/report/report.h"

namespace cross {

/// The same document with every sheet balanced: those that are, as they were worked; the others anew, in the method's
/// own order. \pre the solution has a task that came to its end
Document balanced_document(const Document& document, const Solution& solution);

/// The whole calculation, to be handed in: structure and loads, factors, fixed-end moments, the sheets as they are
/// balanced, the equations of sways, moments beside those of the stiffness method, shears, reactions and the deformed
/// shape, Kani's method and the slope-deflection equations. What cannot be distributed is reported with the reasons.
ui::Report calculation(const Document& document, const Look& look, const ui::Fonts& fonts);

} // namespace cross
