#pragma once

#include "femoop/shape/shape.h"

namespace femoop {

/// A line of three nodes, which may be curved; the ends come first.
///
///      1 o---------o---------o 2 --> xi        N1 = xi (xi - 1) / 2,  N2 = xi (xi + 1) / 2,  N3 = 1 - xi^2
///                  3
class Line3 final : public Shape {
public:
    Line3();
    Values values(NaturalPoint p) const override;
    Derivatives derivatives(NaturalPoint p) const override;
};

} // namespace femoop
