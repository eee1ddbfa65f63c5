#pragma once

#include "femoop/shape/shape.h"

namespace femoop {

/// The triangle of six nodes: complete quadratic.
///
///      eta ^
///          3              corners  N_i = L_i (2 L_i - 1)
///          6 5            middles  N_4 = 4 L1 L2, N_5 = 4 L2 L3, N_6 = 4 L3 L1
///          1-4-2 --> xi   edges 1-2 4, 2-3 5, 3-1 6: Line3
class T6 final : public Shape {
public:
    T6();
    Values values(NaturalPoint p) const override;
    Derivatives derivatives(NaturalPoint p) const override;
};

} // namespace femoop
