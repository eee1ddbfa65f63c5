#include "femoop/geometry/node_position.h"

#include <algorithm>

namespace femoop {

Eigen::Vector3d vector_of(const std::vector<Quantity>& numbers)
{
    Eigen::Vector3d v = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < std::min<std::size_t>(numbers.size(), 3); ++i)
        v[static_cast<Eigen::Index>(i)] = numbers[i];
    return v;
}

Eigen::Vector3d position_of(const Model& model, NodeId node)
{
    const std::array<Quantity, 3>& at = model[node].at;
    return {at[0], at[1], is_3d(model.analysis) ? at[2].value() : 0.0};
}

} // namespace femoop
