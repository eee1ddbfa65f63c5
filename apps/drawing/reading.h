#pragma once

#include "apps/drawing/pick.h"
#include "apps/drawing/view_options.h"
#include "femoop/model/model.h"
#include "femoop/result/results.h"
#include "ui/paint/painter.h"

#include <string>
#include <vector>

namespace drawing {

/// One line of a reading: "M", "−12.5 kN·m", in the looks of a role.
struct ReadingLine {
    std::string name;
    std::string value;
    ui::Role role = ui::Role::Label;
};

/// What is to be read at a cut: where it is, the section forces, the displacements; in an envelope the least and the
/// largest of each, with the cases that govern. Empty where the results lack it.
std::vector<ReadingLine> reading(const femoop::Model& model, const femoop::Results& results, const ViewOptions& options,
                                 const Cut& cut);

/// Draws the reading on a card beside a place of the sheet, where it covers the fewest strings of the picture so far:
/// the values, and of one case the cut member with N, V and M as they act on it. Marks the section in every panel.
///
///         ____________
///        |   member   | ---> N > 0 (tension)
///        |____________| |
///                     ) v V > 0 (along -y')
///                     M > 0 (counter-clockwise)
///
/// \param top  of the part of the sheet that the card may cover [logical pixels]: the legend stands over it
void draw_reading(ui::Painter& painter, const femoop::Model& model, const femoop::Results& results,
                  const ViewOptions& options, const Cut& cut, ui::Point beside, double top = 0.0);

} // namespace drawing
