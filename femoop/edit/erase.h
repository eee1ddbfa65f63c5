#pragma once

#include <vector>

#include "femoop/model/model.h"

namespace femoop {

/// Parts to take out of a model.
struct Parts {
    std::vector<NodeId> nodes;
    std::vector<MemberId> members;
    std::vector<MaterialId> materials;
    std::vector<SectionId> sections;
    std::vector<CaseId> cases; ///< load cases and combinations
};

/// Takes these parts out, and what cannot be without them: members of an erased node; loads, settlements and checks on
/// what is gone; the terms of combinations that name an erased case. The rest keeps its order, so an id counts on from
/// the next smaller one that stays. A part named twice is erased once.
///
/// \pre no member that stays uses an erased material or section \throws std::invalid_argument, the model as it was
void erase(Model& model, const Parts& parts);

bool is_used(const Model& model, MaterialId material);
bool is_used(const Model& model, SectionId section);

} // namespace femoop
