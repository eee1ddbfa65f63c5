#pragma once

#include "apps/plane/view/plate_scene.h"

namespace plane {

/// Principal stresses as crosses, as long as they are large: tension in full lines, compression in dashes of another
/// colour.
void draw_principal(const PlateScene& scene);
/// Trajectories of both principal stresses, those of s1 in full lines, those of s2 in dashes of another colour.
void draw_trajectories(const PlateScene& scene);

/// What the lines mean, for the head of the sheet.
std::string principal_note(const ui::Catalogue& tr);
std::string trajectories_note(const ui::Catalogue& tr);

} // namespace plane
