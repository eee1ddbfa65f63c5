#include "femoop/element/continuum/continuum_element.h"

namespace femoop {

void ContinuumElement::mass(ElementMatrix& M) const
{
    const Eigen::Index n = formulation_.shape().n_nodes();
    M.setZero(2 * n, 2 * n);
    if (formulation_.density() == 0.0) return;
    for (const ShapeAtPoint& point : formulation_.load_points()) {
        const double mass = formulation_.density() * point.weight * volume(point.at);
        for (Eigen::Index i = 0; i < n; ++i)
            for (Eigen::Index j = 0; j < n; ++j) M(2 * i, 2 * j) += mass * point.N[i] * point.N[j];
    }
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j) M(2 * i + 1, 2 * j + 1) = M(2 * i, 2 * j);
}

} // namespace femoop
