#pragma once

#include <string>
#include <vector>

#include "apps/plane/view/plate_picture.h"
#include "femoop/tabular/table.h"

namespace plane {

struct PlateScene;

/// A body whose results are kept, and those that are compared with them: what each mesh is, its unknowns, the largest
/// displacement and the estimated error, and by how much the displacement is another one. \pre there are both results
tabular::Table comparison_table(const PlateInput& input, const PlateOptions& options);

/// The same, a sentence each.
std::vector<std::string> comparison_sentences(const PlateInput& input, const PlateOptions& options);

/// "kept: 336 Q8", "now: 336 Q4": over bodies side by side.
std::string mesh_title(bool is_kept, const PlateInput& input, const PlateOptions& options);

/// The table in a box.
void draw_comparison(ui::Painter& painter, const PlateInput& input, const PlateOptions& options, const ui::Box& box);

/// The kept body where its displacements take it, as many times as large as those of the other one: dashes, with the
/// sides of its elements where meshes are shown.
void draw_kept_shape(const PlateScene& scene, const femoop::plane::PlaneModel& mesh,
                     const std::vector<Eigen::Vector2d>& places);

} // namespace plane
