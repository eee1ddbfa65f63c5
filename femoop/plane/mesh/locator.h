#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "femoop/element/continuum/element_geometry.h"
#include "femoop/plane/model/plane_model.h"
#include "femoop/shape/natural_point.h"

namespace femoop::plane {

/// A place in an element.
struct Location {
    ElementId element;
    NaturalPoint at;
};

/// Where a place of the plane lies in an element, by Newton's method; a place outside is that of the nearest natural
/// point. Of a place on its border the element says yes too.
struct NaturalPlace {
    NaturalPoint at;
    double distance = 0.0; ///< from the element, relative to its size; 0 inside
};
NaturalPlace natural_place(const Shape& shape, const NodePositions& X, const Eigen::Vector2d& at);

/// Finds the elements that hold a place.
class Locator {
public:
    /// \pre every element of the model is sound, and the model outlives this
    explicit Locator(const PlaneModel& model);

    /// All elements that hold the place: one inside, several on a border. Where elements' sides miss a curved outline,
    /// as neighbours that turn a little or a bent side show, the nearest one; nothing further away.
    std::vector<Location> find(const Eigen::Vector2d& at) const;

    /// Those whose boxes meet a box.
    std::vector<ElementId> in_box(const Eigen::Vector2d& low, const Eigen::Vector2d& high) const;

private:
    struct Box {
        Eigen::Vector2d low, high;
    };
    using Cell = Eigen::Matrix<int, 2, 1>;
    Cell cell_of(const Eigen::Vector2d& at) const;
    std::optional<Location> nearest(const Eigen::Vector2d& at) const;
    double curve_beyond(ElementId element, const Eigen::Vector2d& at) const;

    const PlaneModel& model_;
    std::vector<Box> boxes_;
    Eigen::Vector2d low_, step_;
    int n_ = 1; ///< cells along each side
    std::vector<std::uint32_t> start_;
    std::vector<std::uint32_t> in_cell_;
};

} // namespace femoop::plane
