#include "topology/modeling/shell_and_hole.h"

#include "topology/halfedge/check/shells.h"

namespace topology {

namespace {

FaceId do_both(EulerOperator& op, const ShellAndHole& parts)
{
    const FaceId made = op.mfkrh(parts.ring);
    op.kfmrh(parts.host, parts.face);
    return made;
}

/// Tries on a copy, because whether MFKRH separates is seen when it is done.
void require_change(const EulerOperator& op, const ShellAndHole& parts, bool is_made)
{
    Solid trial = op.solid();
    const EulerCounts before = euler_counts(trial);
    EulerOperator on_trial(trial);
    do_both(on_trial, parts);
    const EulerCounts after = euler_counts(trial);
    const bool is_right = is_made ? after.S == before.S + 1 && after.G == before.G + 1
                                  : after.S + 1 == before.S && after.G + 1 == before.G;
    if (!is_right)
        throw EulerError({.kind = RefusalKind::NoShellAndHole, .entities = {parts.ring, parts.face, parts.host}});
}

} // namespace

FaceId make_shell_and_hole(EulerOperator& op, const ShellAndHole& parts)
{
    require_change(op, parts, true);
    return do_both(op, parts);
}

FaceId kill_shell_and_hole(EulerOperator& op, const ShellAndHole& parts)
{
    require_change(op, parts, false);
    return do_both(op, parts);
}

} // namespace topology
