#pragma once

#include "apps/plane/document/document.h"

namespace plane {

/// Adds the points and curves of a drawing, under ids that are free here; a point that lies where one is already is that
/// one. Nothing else of it is taken. \pre it is in the document's units
void insert_drawing(Document& document, const PlaneModel& drawing);

} // namespace plane
