#pragma once

#include <functional>

#include "femoop/model/load.h"

namespace femoop {

/// Changes that go through a load on a member, whatever its kind.

/// Every place along the member.
void change_places(MemberLoad& load, const std::function<void(Position&)>& change);

/// Every force, moment and intensity, with its direction and the axes that it is in.
void change_values(MemberLoad& load, const std::function<void(Dof, Quantity&, LoadAxes)>& change);

/// What is at the member's first end goes to its second and back; places are left to `change_places`.
void swap_ends(MemberLoad& load);

/// Top and bottom change places.
void swap_faces(MemberLoad& load);

} // namespace femoop
