#pragma once

#include "apps/drawing/draw_options.h"
#include "apps/drawing/sketch/scene.h"
#include "femoop/methods/virtual_work/virtual_work.h"
#include "ui/text/display_units.h"

#include <string>
#include <vector>

namespace drawing {

/// A displacement by virtual work, to be drawn as the forces under the loads, those under the unit load, and the table of
/// their products.
struct WorkPicture {
    femoop::virtual_work::VirtualWork work;
};

/// What the unit load is measured in: a force, or of a rotation a moment.
ui::Measure unit_load_measure(const WorkPicture& picture);

/// One diagram beside the other: of the first kind of force that the options show, else of the moments, of a truss of
/// the axial forces; with the loads that they come from.
DrawOptions with_unit_load(DrawOptions options, femoop::AnalysisKind kind);

/// The displacement as the sum of the work beside what the analysis has, and what the letters of the table mean.
std::vector<std::string> work_sentences(const WorkPicture& picture, const femoop::Model& model,
                                        const ui::DisplayUnits& units, const ui::Catalogue& tr);

} // namespace drawing
