#pragma once

#include <memory>

#include "apps/plane/discretize/drawing.h"
#include "femoop/io/plane/plane_file.h"

namespace cli {

/// The drawing of a plane model, where it is drawn and nothing is wrong with its file; what is wrong with the drawing
/// joins the reading's faults. The reading must outlive it.
std::unique_ptr<const discretize::Drawing> drawing_of(femoop::plane::PlaneReading& reading);

} // namespace cli
