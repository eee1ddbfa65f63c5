#include "femoop/result/element_field.h"

#include <cstddef>

#include "femoop/shape/shape.h"

namespace femoop {

namespace {

ElementVector picked(const ElementDofs& dofs, std::span<const double> displacements)
{
    const std::size_t n = dofs.of_each_node.size();
    ElementVector u(static_cast<Eigen::Index>(dofs.n_of_nodes()));
    for (std::size_t i = 0; i < dofs.n_of_nodes(); ++i)
        u[static_cast<Eigen::Index>(i)] = displacements[dofs.nodes[i / n].index * n + i % n];
    return u;
}

} // namespace

ElementField::ElementField(const ContinuumElement& element, std::span<const double> displacements,
                           ContinuumElement::Heat heat)
    : element_(element), u_(picked(element.dofs(), displacements)), heat_(heat)
{}

Eigen::Vector2d ElementField::displacement(NaturalPoint p) const
{
    const Shape::Values N = element_.formulation().shape().values(p);
    return u_.reshaped(2, N.size()) * N;
}

} // namespace femoop
