#pragma once

#include "apps/plane/view/plate_scene.h"

namespace plane {

/// Principal stresses as crosses, as long as they are large: tension in full lines, compression in dashes of another
/// colour.
void draw_principal(const PlateScene& scene);
/// Trajectories of both principal stresses, those of s1 in full lines, those of s2 in dashes of another colour.
void draw_trajectories(const PlateScene& scene);

/// Displacements as arrows at equal distances: from places at rest to where the deformed shape takes them where that is
/// drawn, else the largest of the body as long as leaves the arrows apart.
void draw_vectors(const PlateScene& scene);

/// What the lines mean, for the head of the sheet.
std::string principal_note(const ui::Catalogue& tr);
std::string trajectories_note(const ui::Catalogue& tr);
/// \param largest  displacement of the body, with its unit
std::string vectors_note(const std::string& largest, const ui::Catalogue& tr);

} // namespace plane
