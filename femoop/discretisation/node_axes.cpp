#include "femoop/discretisation/node_axes.h"

#include <algorithm>
#include <cmath>

#include "femoop/element/analysis_model.h"

namespace femoop {

NodeAxes::NodeAxes(const Discretisation& structure) : dofs_(model_dofs(structure.kind))
{
    for (const Discretisation::SupportRow& support : structure.supports) {
        if (support.angle == 0.0) continue;
        turns_.resize(structure.positions.size());
        turns_[support.node.index] = {.cosine = std::cos(support.angle), .sine = std::sin(support.angle)};
    }
}

bool NodeAxes::are_turned(const ElementDofs& dofs) const
{
    return !turns_.empty() && std::ranges::any_of(dofs.nodes, [&](NodeId node) { return are_turned(node); });
}

} // namespace femoop
