#pragma once

#include <Eigen/Core>
#include <vector>

#include "femoop/plane/mesh/locator.h"

namespace femoop::plane {

/// A straight cut through a body.
///
///      y' ^ 2
///         |
///         +--> x'      y' runs from the first to the second end, x' is y' turned by -90 degrees
///         1
struct Cut {
    Eigen::Vector2d start, end;

    double length() const { return (end - start).norm(); }
    Eigen::Vector2d along() const { return (end - start) / length(); }     ///< y'
    Eigen::Vector2d normal() const { return {along().y(), -along().x()}; } ///< x'
    Eigen::Vector2d at(double s) const { return start + s * along(); }
};

/// A part of a cut that lies in one element, or on the border between some.
struct CutPiece {
    double from = 0.0, to = 0.0;     ///< lengths from the first end
    std::vector<ElementId> elements; ///< that hold it
};

/// The parts of a cut that lie in material, in its direction. \pre the cut has a length
std::vector<CutPiece> pieces_along(const PlaneModel& model, const Locator& locator, const Cut& cut);

} // namespace femoop::plane
