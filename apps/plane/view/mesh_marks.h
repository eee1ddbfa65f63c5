#pragma once

#include "apps/plane/view/plate_scene.h"

namespace plane {

/// The sides of all elements, curved ones as curves, where the body is drawn. They are drawn as few long lines.
void draw_mesh(const PlateScene& scene);
/// The same of any mesh whose points are at these places.
void draw_sides(const PlateScene& scene, const femoop::plane::PlaneModel& mesh, const PlaceLine& places,
                const ui::Stroke& stroke);
/// The body where its displacements take it, over its outline at rest.
void draw_deformed(const PlateScene& scene);

/// The body where a motion without strain takes it, over its outline at rest.
void draw_mechanism(const PlateScene& scene);
/// Of all points of the mesh, moved by a share of a motion whose largest displacement is drawn as a tenth of the body.
PlaceLine moved_by(const femoop::plane::PlaneModel& mesh, const std::vector<femoop::NodeVector>& motion, double share);
PlaceLine moved_by(const femoop::plane::PlaneModel& mesh, const std::vector<Eigen::Vector2d>& motion, double share);

/// Of all points of the mesh, as a length.
double largest_displacement(const femoop::plane::PlaneModel& mesh, const femoop::plane::PlaneCase& result);

/// The round factor by which displacements are drawn: the one asked for, else one that makes the largest about a tenth of
/// the body; of results that are compared with kept ones the least of both, so that they are drawn alike.
double magnification(const PlateInput& input, const femoop::plane::PlaneCase& result, const PlateOptions& options);
/// Of all points of the mesh, moved by so many times their displacements.
PlaceLine displaced(const femoop::plane::PlaneModel& mesh, const femoop::plane::PlaneCase& result, double factor);

} // namespace plane
