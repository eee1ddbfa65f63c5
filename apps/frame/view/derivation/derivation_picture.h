#pragma once

#include <cstddef>
#include <optional>

#include "femoop/methods/derivation/derivation.h"
#include "femoop/model/model.h"
#include "ui/paint/painter.h"
#include "ui/paint/theme.h"
#include "ui/text/catalogue.h"
#include "ui/text/display_units.h"

namespace frame {

/// Which step is drawn, and how.
struct DerivationLook {
    ui::Theme theme;
    ui::Catalogue tr;                    ///< language of the words
    ui::DisplayUnits units;              ///< of the number itself; matrices are in the file's own
    std::size_t step = 0;                ///< from 0; the last one where it is beyond
    std::optional<double> seen_height{}; ///< of a sheet that is scrolled: what is seen of it at once; else all
};

/// A sheet that holds a step's matrices whole, as small as they can be read; no smaller than `room`.
ui::Size sheet_for(const femoop::derivation::Derivation& derivation, const femoop::Model& model,
                   const DerivationLook& look, ui::Size room, const ui::Fonts& fonts);

/// Draws one step of the way to a number on the painter's whole sheet: the number, the step's sentence, its matrices
/// with names beside them, and at the right K as a heat map, where the step stands in it framed; beside a
/// wide matrix it is narrower, or left out.
///
///     M(BC, 3 m) = 12.5 kN·m in wind                       step 4 of 9
///     In the axes of the nodes k = T^T k' T. Each row ...
///     k   B.ux  B.uy                                  K  1 2 3 | f
///     B.ux  [ 12    0 ]                              1   # #   | .
///     B.uy  [  0    3 ]                              2   # #   | #
///
/// A cell of K is the darker the larger its number, three powers of ten and more apart; a negative one has a bar.
void draw_derivation(ui::Painter& painter, const femoop::derivation::Derivation& derivation, const femoop::Model& model,
                     const DerivationLook& look);

} // namespace frame
