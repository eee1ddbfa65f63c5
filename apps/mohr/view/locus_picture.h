#pragma once

#include "apps/mohr/view/scene.h"

namespace mohr {

/// There is a criterion to be shown among principal stresses.
bool has_locus(const Scene& scene);

/// What the criterion allows among the principal stresses, with the state in it: of a plane state in the axes of its
/// two principal stresses, with the way along which it grows to failure; of a state in space in the deviatoric plane of
/// its mean stress. \pre has_locus(scene)
void draw_locus(ui::Painter& painter, const Scene& scene, const ui::Box& box);

} // namespace mohr
