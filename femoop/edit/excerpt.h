#pragma once

#include <vector>

#include "femoop/model/model.h"

namespace femoop {

/// Some members cut out of a structure, with their nodes, supports and loads; load cases and combinations stay.
///
///       C       D       E            C       D                 the members AB.. that were chosen; at D the
///       o-------o-------o            o-------#                 member DE was left out, so D is held fixed
///       |       |       |     ->     |       |
///       A       B       F            A       B
///
/// Signs    a clamp at a cut is what a sub-frame assumes of the far end of its last member
struct Excerpt {
    Model model;              ///< without expected results and blocks of other programs, which speak of the whole
    std::vector<NodeId> held; ///< nodes of `model` where members were left out: fixed
};

/// \pre the members are of the model
Excerpt excerpt_of(const Model& model, const std::vector<MemberId>& members);

/// Without what a file says beside its structure: title, notes, expected results, blocks of other programs.
Model structure_alone(Model model);

} // namespace femoop
