#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace femoop {

/// A place on an element's edge, which is walked with the element to the left.
struct EdgePoint {
    Eigen::Vector2d at;
    Eigen::Vector2d along;   ///< unit vector in the direction of the edge
    Eigen::Vector2d outward; ///< unit vector out of the element
    double xi = 0.0;         ///< natural coordinate along the edge, from -1 to 1 in its direction
};

/// Force per area that acts on an edge's face, along the global axes.
struct EdgeLoad {
    int edge = 0; ///< of the element's shape
    std::function<Eigen::Vector2d(const EdgePoint&)> traction;
    std::vector<double> kinks{}; ///< natural coordinates between the ends where it has one, ascending
};

/// Force per volume at a place, along the global axes.
struct BodyLoad {
    std::function<Eigen::Vector2d(const Eigen::Vector2d&)> force;
};

/// A rise of temperature at a place [K]: it strains the material, which is free to follow or not.
struct ThermalLoad {
    std::function<double(const Eigen::Vector2d&)> rise;
};

} // namespace femoop
