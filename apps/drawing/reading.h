#pragma once

#include "apps/drawing/cut.h"
#include "apps/drawing/draw_input.h"
#include "apps/drawing/draw_options.h"
#include "apps/drawing/sheet/subject.h"
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
std::vector<ReadingLine> reading(const femoop::Model& model, const femoop::Results& results, const DrawOptions& options,
                                 const Cut& cut);

/// A reading on the sheet of a picture.
struct ReadingCard {
    const Subject::Plan& plan; ///< of the picture
    Cut cut;
    ui::Point beside; ///< the card stands beside it
    double top = 0.0; ///< of the part of the sheet that it may cover [logical pixels]: the legend stands over it
};

/// Draws the reading on a card beside a place of the sheet, where it covers the fewest strings of the picture so far:
/// the values, and of one case the cut member with N, V and M as they act on it. Marks the section in every panel.
///
///         ____________
///        |   member   | ---> N > 0 (tension)
///        |____________| |
///                     ) v V > 0 (along -y')
///                     M > 0 (counter-clockwise)
///
/// Nothing where the input has no results of the case.
void draw_reading(ui::Painter& painter, const DrawInput& input, const DrawOptions& options, const ReadingCard& card);
/// The same with the lines of an envelope that is not of the input's cases.
void draw_reading(ui::Painter& painter, const femoop::Model& model, const DrawOptions& options, const ReadingCard& card,
                  const std::vector<ReadingLine>& lines);

} // namespace drawing
