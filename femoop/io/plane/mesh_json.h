#pragma once

#include "femoop/io/json/json_writer.h"
#include "femoop/plane/model/plane_model.h"

namespace femoop::plane {

/// The member "mesh" of results: its size and quality, and where it is full its points and elements too.
void write_mesh(JsonWriter& json, const PlaneModel& model, bool is_full);

} // namespace femoop::plane
