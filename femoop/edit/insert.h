#pragma once

#include <string>

#include "femoop/edit/place.h"
#include "femoop/model/model.h"

namespace femoop {

/// Puts another model into this one, each of its nodes placed anew, its numbers counted in this model's units:
///
///       +---+                   +---+
///       |   |    +   o--o--o    |   |   o--o--o
///       model        other           model
///
/// Materials that are alike are shared, and sections (femoop/edit/condense.h). Load cases of one name and one
/// self-weight are one, and combinations of one name and the same terms. Any other name that is taken is made fresh.
/// Nothing is joined: see femoop/edit/weld.h. Title, notes, checks (`expected`) and extra blocks of the other stay out.
/// \returns the nodes, members, materials, sections and cases that are new
/// \throws std::invalid_argument where the two are of different analyses, the model as it was
Parts insert(Model& model, const Model& other, const Placement& placement);

/// Adds an empty load case behind the others; combinations count on from it. \pre the name is free
CaseId insert_load_case(Model& model, std::string id);

} // namespace femoop
