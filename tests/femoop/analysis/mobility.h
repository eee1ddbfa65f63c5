#pragma once

#include "femoop/model/model.h"

/// How a structure can move, from its geometry alone: every member has six displacements at either end, which joints
/// tie to the nodes. Dense and slow, and it shares nothing with the analysis that it judges.
struct Mobility {
    int n_free = 0; ///< motions without strain
    int n_mechanisms =
        0; ///< of them those that are no spin: of a node whose members are hinged, of a member about its axis
    bool is_clear = true; ///< no motion is so soft that rounding might decide
};

Mobility mobility(const femoop::Model& model);

/// A structure made at random of few nodes in rows and squares, so that many are mechanisms, and some of them only
/// because of their shape: hinges, releases, rigid and inextensible members, bars, offsets, springs, inclined supports.
femoop::Model random_linkage(femoop::AnalysisKind kind, unsigned seed);
