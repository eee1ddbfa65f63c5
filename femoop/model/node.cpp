#include "femoop/model/node.h"

namespace femoop {

DofSet Support::blocked(AnalysisKind analysis) const
{
    DofSet wanted = fixed;
    switch (kind) {
    case SupportKind::Custom: break;
    case SupportKind::Fixed: wanted = {Dof::ux, Dof::uy, Dof::uz, Dof::rx, Dof::ry, Dof::rz}; break;
    case SupportKind::Pin: wanted = {Dof::ux, Dof::uy, Dof::uz}; break;
    case SupportKind::Roller: wanted = {Dof::uy}; break;
    }
    DofSet held;
    for (const Dof dof : all_dofs)
        if (wanted.contains(dof) && dofs(analysis).contains(dof)) held.insert(dof);
    return held;
}

} // namespace femoop
