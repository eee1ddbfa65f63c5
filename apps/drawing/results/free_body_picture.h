#pragma once

#include "apps/drawing/sketch/scene.h"
#include "femoop/methods/free_body/free_body.h"

#include <optional>
#include <string>
#include <vector>

namespace drawing {

/// A part of the structure, lifted out and moved aside with all that acts on it.
struct FreeBodyPicture {
    femoop::free_body::FreeBody lifted;
    Eigen::Vector3d aside = Eigen::Vector3d::Zero(); ///< how far it is moved
    Eigen::Vector3d about = Eigen::Vector3d::Zero(); ///< the point of moments, where the body was [length]
    std::optional<std::size_t> ritter{};             ///< which of its Ritter points moments are taken about
    std::vector<std::string> equations{};            ///< for the foot of the sheet

    Eigen::Vector3d moment_point() const { return about + aside; } ///< where it is seen
};

/// The ends of its parts and the point of moments, where they are seen.
std::vector<Eigen::Vector3d> places_of(const FreeBodyPicture& picture, const StructureShape& shape);

/// Section forces as arrows along and across the member, at a node on stubs of the members that are cut off there, named
/// and with their values; loads that are distributed as their resultants; the point of moments as a cross in a ring;
/// Ritter points as crosses with the names of their bars, and the lines that meet in that of the moments.
void draw_free_body(const Scene& scene, const FreeBodyPicture& picture);

} // namespace drawing
