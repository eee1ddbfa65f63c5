#pragma once

#include "apps/frame/view/derivation/derivation_picture.h"
#include "ui/paint/geometry.h"
#include "ui/paint/painter.h"

namespace frame {

/// K of more unknowns is not drawn: its cells would be dots.
inline constexpr std::size_t most_unknowns_mapped = 400;

/// K as a heat map with f beside it, in a box; the rows that the step is about are framed: of a member the cells that
/// it has a part in, else whole rows. Where ties leave fewer equations, a step of those shows what is left.
///
/// Of a cell  darker where its number is larger, on a scale of powers of ten; a bar where it is negative
void draw_stiffness_map(ui::Painter& painter, const femoop::derivation::Derivation& derivation,
                        const femoop::derivation::Step& step, const femoop::Model& model, const DerivationLook& look,
                        const ui::Box& box);

/// Beside one another what is solved as it is numbered on paper and as the solver eliminates, each with its half
/// bandwidth. \pre a step of the numbering
void draw_numbering(ui::Painter& painter, const femoop::derivation::Derivation& derivation,
                    const femoop::derivation::Step& step, const femoop::Model& model, const DerivationLook& look,
                    const ui::Box& box);

} // namespace frame
