#pragma once

#include "femoop/shape/shape.h"

namespace femoop {

/// The quadrilateral of nine nodes: biquadratic, the product of two Line3.
///
///          4---7---3
///          |   ^eta|      N_i = l(xi) l(eta) with the functions l of Line3
///          8   9-> 6xi    edges 1-2 5, 2-3 6, 3-4 7, 4-1 8: Line3
///          |       |
///          1---5---2
class Q9 final : public Shape {
public:
    Q9();
    Values values(NaturalPoint p) const override;
    Derivatives derivatives(NaturalPoint p) const override;
};

} // namespace femoop
