#pragma once

#include "femoop/shape/shape.h"

namespace femoop {

/// The quadrilateral of eight nodes: the quadratic serendipity element.
///
///          4---7---3      corners       N_i = (1 + xi_i xi) (1 + eta_i eta) (xi_i xi + eta_i eta - 1) / 4
///          |   ^eta|      xi_i = 0      N_i = (1 - xi^2) (1 + eta_i eta) / 2
///          8   +-> 6xi    eta_i = 0     N_i = (1 + xi_i xi) (1 - eta^2) / 2
///          |       |      edges 1-2 5, 2-3 6, 3-4 7, 4-1 8: Line3
///          1---5---2
class Q8 final : public Shape {
public:
    Q8();
    Values values(NaturalPoint p) const override;
    Derivatives derivatives(NaturalPoint p) const override;
};

} // namespace femoop
