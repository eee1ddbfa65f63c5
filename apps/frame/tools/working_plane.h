#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "femoop/model/quantity/quantity.h"

namespace frame {

/// The plane in which a pointer draws a model in space: square to one axis, so far along it. Its own axes are the two
/// others in their order: xy, xz or yz.
struct WorkingPlane {
    enum class Normal : std::uint8_t { X, Y, Z };
    Normal normal = Normal::Z;
    femoop::Quantity level{0.0}; ///< along the normal [length]

    Eigen::Index index() const { return static_cast<Eigen::Index>(normal); } ///< of the normal, 0 to 2
    Eigen::Vector3d normal_axis() const { return Eigen::Vector3d::Unit(index()); }
    Eigen::Vector3d first() const { return Eigen::Vector3d::Unit(normal == Normal::X ? 1 : 0); }
    Eigen::Vector3d second() const { return Eigen::Vector3d::Unit(normal == Normal::Z ? 1 : 2); }
    /// A place's two coordinates in the plane, and back: on the plane, or as far off it as said.
    Eigen::Vector2d in_plane(const Eigen::Vector3d& place) const { return {place.dot(first()), place.dot(second())}; }
    Eigen::Vector3d in_space(const Eigen::Vector2d& place) const { return in_space(place, level); }
    Eigen::Vector3d in_space(const Eigen::Vector2d& place, double at_level) const
    {
        return place.x() * first() + place.y() * second() + at_level * normal_axis();
    }

    friend bool operator==(const WorkingPlane&, const WorkingPlane&) = default;
};

} // namespace frame
