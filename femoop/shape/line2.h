#pragma once

#include "femoop/shape/shape.h"

namespace femoop {

/// A line of two nodes.
///
///      1 o---------+---------o 2 --> xi        N1 = (1 - xi) / 2,  N2 = (1 + xi) / 2
class Line2 final : public Shape {
public:
    Line2();
    Values values(NaturalPoint p) const override;
    Derivatives derivatives(NaturalPoint p) const override;
};

} // namespace femoop
