#pragma once

#include <array>
#include <filesystem>
#include <memory>

#include "topology/geometry/flat_point.h"
#include "ui/paint/image.h"

namespace plane {

using topology::FlatPoint;
using topology::FlatVector;

/// An image behind the drawing, over which it is drawn. It is moved, turned and made larger or smaller, but never
/// stretched nor mirrored.
struct Backdrop {
    std::shared_ptr<const ui::Photo> photo; ///< never null
    std::filesystem::path file;             ///< that it is read from, from the root on
    FlatPoint corner;                       ///< of the image's bottom left
    FlatVector across{1.0, 0.0};            ///< along the whole of its bottom side [length]
    double opacity = 0.6;                   ///< `least_opacity` to 1

    FlatVector up() const; ///< along the whole of its left side [length]
    /// From the bottom left corner, counter-clockwise where the image is upright.
    std::array<FlatPoint, 4> corners() const;

    friend bool operator==(const Backdrop&, const Backdrop&) = default;
};

inline constexpr double least_opacity = 0.05;

/// A PNG or JPEG image, by the ending of its name.
bool is_image_file(const std::filesystem::path& path);

/// Upright in the middle of a rectangle from `low` to `high`, as large as fits it.
/// \pre the photo is not null, and the rectangle has a width and a height
Backdrop backdrop_within(std::shared_ptr<const ui::Photo> photo, std::filesystem::path file, const FlatPoint& low,
                         const FlatPoint& high);

/// Two places of a backdrop, and where they belong.
struct Alignment {
    std::array<FlatPoint, 2> from, to;

    friend bool operator==(const Alignment&, const Alignment&) = default;
};

/// The backdrop where both places are where they belong.
/// \pre the places of either pair are apart
Backdrop aligned(const Backdrop& backdrop, const Alignment& alignment);

} // namespace plane
