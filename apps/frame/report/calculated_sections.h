#pragma once

#include "femoop/model/model.h"

namespace frame {

/// The model with the properties that its sections have from a shape or a profile written out beside what was typed:
/// area, depth, and what this analysis uses of second moments, torsion constant and shear areas. A section that cannot
/// be stays as it is.
femoop::Model with_calculated_sections(femoop::Model model);

} // namespace frame
