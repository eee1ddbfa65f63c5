#pragma once

#include "apps/drawing/geometry/projection.h"
#include "apps/drawing/geometry/structure_shape.h"

namespace drawing {

/// How close together the members stand on the sheet. Where they are short, symbols get smaller and leave out what
/// could not be told apart, until one zooms in: a thousand members stay a picture, and stay fast.
class LevelOfDetail {
public:
    LevelOfDetail(const StructureShape& shape, const Projection& projection);

    double median_length() const { return median_length_; }  ///< of the members [px]; 0 where there is none
    bool is_reduced() const { return symbol_share() < 1.0; } ///< there is no room for details within members
    /// What is left of the size of symbols: 1 where there is room, at least 0.5.
    double symbol_share() const;

private:
    double median_length_ = 0.0;
};

} // namespace drawing
