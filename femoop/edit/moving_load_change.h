#pragma once

#include <functional>
#include <vector>

#include "femoop/model/model.h"

namespace femoop {

/// Every list of members that a load moves along: of the model's paths, and those spelled out.
void change_paths(Model& model, const std::function<void(std::vector<MemberId>&)>& change);

/// A path before the others: the first one is meant where none is named.
void lead_with(MovingLoads& moving, LoadPath path);

/// A path over a member that was cut in two goes on over both. \pre the second part begins where the first ends
void follow_split(Model& model, MemberId first, MemberId second);

/// A path over one of two members that become one, or over both, goes over the whole.
void follow_merge(Model& model, MemberId first, MemberId second);

/// What moves over one model, over another that has the same names: without what refers to parts that it lacks.
/// \pre the other is sound but for its own moving loads, which are not looked at
MovingLoads carried_over(const Model& from, const Model& to);

} // namespace femoop
