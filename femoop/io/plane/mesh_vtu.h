#pragma once

#include <string>

#include "femoop/plane/model/plane_model.h"

namespace femoop::plane {

/// The mesh as an unstructured grid of VTK's XML format (.vtu), which ParaView and others read: nodes, cells, and of each
/// cell the number of its region, from 0. \pre the model has elements
std::string mesh_vtu(const PlaneModel& model);

} // namespace femoop::plane
