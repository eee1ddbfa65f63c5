#pragma once

#include "apps/drawing/sketch/scene.h"
#include "apps/drawing/sketch/symbols.h"

#include <string>

namespace drawing {

/// The load that an arrow stands for.
struct GripOf {
    Part load;
    femoop::Dof dof;
};

/// A force as an arrow with its value.
struct ForcePicture {
    Eigen::Vector3d at;
    Eigen::Vector3d direction; ///< unit, of the force
    double length = 40.0;      ///< logical pixels
    ArrowAt touches = ArrowAt::Head;
    double gap = 0.0; ///< from the place to the arrow
    std::string text;
    ui::Role role = ui::Role::Load;
    int n_heads = 1;
    std::optional<ui::Point> text_side{};         ///< where its value would stand; else in line with it
    std::optional<GripOf> grip{};                 ///< it can be pulled
    std::optional<femoop::MovingEffect> number{}; ///< of the results that its value is
};
void draw_force(const Scene& scene, const ForcePicture& force);

/// A moment: a curved arrow in the plane, a vector with two heads in space.
struct MomentPicture {
    Eigen::Vector3d at;
    Eigen::Vector3d axis; ///< unit, right-handed
    std::string text;
    ui::Role role = ui::Role::LoadMoment;
    double radius = 16.0;
    ui::Point text_side{0.7, -0.7};               ///< where its value would stand
    std::optional<GripOf> grip{};                 ///< it can be pulled
    std::optional<femoop::MovingEffect> number{}; ///< of the results that its value is
};
void draw_moment(const Scene& scene, const MomentPicture& moment);

/// On which side of a node, above it, a text hides no member.
ui::Point text_side(const Scene& scene, femoop::NodeId node);

/// Which end of an arrow is put at a node, so that it hides no member.
ArrowAt free_end(const Scene& scene, femoop::NodeId node, const Eigen::Vector3d& direction);

} // namespace drawing
