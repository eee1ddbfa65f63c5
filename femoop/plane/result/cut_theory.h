#pragma once

#include <vector>

#include "femoop/plane/analysis/plane_results.h"

namespace femoop::plane {

/// What the theory of beams says of a cut, from the N, V and M that act on it: plane sections stay plane, and the shear
/// stress follows from equilibrium.
///
///      sigma(s) = E (N / EA - M (s - s_c) / EI)      M about the centroid s_c, positive where it stretches small s
///      tau(s)   = -V EQ(s) / (EI t)                  EQ: of what lies beyond s, about s_c
///
/// with all E equal: N/A - M y/I and V Q/(I t). E is the stiffness of each material, in plane strain E/(1 - nu^2).
///
/// Signs   as of a cut (femoop/plane/mesh/cut.h): sigma on the face x', tension positive; tau along +y' on it
/// Source  [GereTimoshenko, ch. 5]; [TimoshenkoGoodier1970, ch. 3] compares both for a cantilever
struct CutTheory {
    struct Station {
        double s = 0.0;
        double sigma = 0.0, tau = 0.0;
    };
    double centroid = 0.0;         ///< s_c
    std::vector<Station> stations; ///< piece after piece of the material, ends included
};

/// \param n  stations of each piece, at least 2  \pre the cut meets material, and the body is not one of revolution
CutTheory beam_theory(const PlaneResults& results, const PlaneCase& result, const Cut& cut, int n = 9);

} // namespace femoop::plane
