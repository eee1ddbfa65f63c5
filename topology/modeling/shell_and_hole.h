#pragma once

#include "topology/halfedge/operators/euler_operator.h"

namespace topology {

/// Make Shell, Hole (MSG in the lecture's table): S+1 G+1, a lesson made of two operators.
///
///      MFKRH of a ring that alone connects two parts     F+1 S+1
///      KFMRH of two faces that lie in one shell then     F-1 G+1
///
/// \returns the face that the ring bounds now   \throws EulerError and leaves the solid as it was
struct ShellAndHole {
    LoopId ring;       ///< which MFKRH takes away
    FaceId host, face; ///< of KFMRH: `face` becomes a ring of `host`
};
FaceId make_shell_and_hole(EulerOperator& op, const ShellAndHole& parts);
/// Its inverse, KSG: MFKRH of the handle's ring, KFMRH that joins the two shells.   S-1 G-1
FaceId kill_shell_and_hole(EulerOperator& op, const ShellAndHole& parts);

} // namespace topology
