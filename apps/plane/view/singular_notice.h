#pragma once

#include <optional>
#include <string>

#include "apps/plane/discretize/drawing.h"
#include "apps/plane/view/plate_picture.h"

namespace plane {

/// That stresses grow with the mesh at the corners of a drawing that have no bound, with their places; nothing where
/// there are none.
std::optional<std::string> singular_notice(const discretize::Drawing& drawing, const PlateOptions& options);
/// The same in as few words as a legend has room for.
std::optional<std::string> singular_note(const discretize::Drawing& drawing, const PlateOptions& options);
/// Stresses or strains, or what follows from them, are shown.
bool shows_stresses(const PlateOptions& options);

} // namespace plane
