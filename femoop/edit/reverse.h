#pragma once

#include "femoop/model/model.h"

namespace femoop {

/// Turns a member round: its first end becomes its second. Its loads, releases, springs and offsets stay where they are
/// on the structure, so displacements and reactions stay; its own axes turn (x' and y' in plane models, x' and z'
/// otherwise), and with them the signs of its results and, in plane models, a section that is not symmetric about z'.
/// Checks (`expected`) along the member are dropped, since they are written in its axes.
void reverse_member(Model& model, MemberId member);

} // namespace femoop
