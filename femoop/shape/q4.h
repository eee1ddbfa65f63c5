#pragma once

#include "femoop/shape/shape.h"

namespace femoop {

/// The quadrilateral of four nodes: bilinear.
///
///          4-------3
///          |   ^eta|      N_i = (1 + xi_i xi) (1 + eta_i eta) / 4
///          |   +-> |xi    edges 1-2, 2-3, 3-4, 4-1: Line2
///          1-------2
///
/// Accuracy it has no bending mode and locks in shear: one element alone, of length 2a and depth 2b, is in plane stress
///          1 / (1 - nu^2) + (a / b)^2 / 2 (1 + nu) times as stiff as the beam
/// Source   [CookMalkusPleshaWitt2002]
class Q4 final : public Shape {
public:
    Q4();
    Values values(NaturalPoint p) const override;
    Derivatives derivatives(NaturalPoint p) const override;
};

} // namespace femoop
