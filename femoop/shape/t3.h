#pragma once

#include "femoop/shape/shape.h"

namespace femoop {

/// The triangle of three nodes: linear, its strains are constant.
///
///      eta ^
///          3              N = L1, L2, L3        edges 1-2, 2-3, 3-1: Line2
///          | `.
///          1---2 --> xi
class T3 final : public Shape {
public:
    T3();
    Values values(NaturalPoint p) const override;
    Derivatives derivatives(NaturalPoint p) const override;
};

} // namespace femoop
