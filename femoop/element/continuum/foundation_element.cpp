#include "femoop/element/continuum/foundation_element.h"

#include <utility>

#include "femoop/element/continuum/continuum_model.h"

namespace femoop {

FoundationElement::FoundationElement(std::vector<NodeId> nodes, std::vector<Point> points)
    : nodes_(std::move(nodes)), points_(std::move(points))
{}

ElementDofs FoundationElement::dofs() const { return {.nodes = nodes_, .of_each_node = plane_dofs}; }

void FoundationElement::stiffness(ElementMatrix& K) const
{
    const auto n = static_cast<Eigen::Index>(nodes_.size());
    K = ElementMatrix::Zero(2 * n, 2 * n);
    for (const Point& point : points_)
        for (Eigen::Index i = 0; i < n; ++i)
            for (Eigen::Index j = 0; j < n; ++j)
                K.block<2, 2>(2 * i, 2 * j) += point.area * point.N[i] * point.N[j] * point.k;
}

void FoundationElement::equivalent_forces(const ElementLoads& loads, ElementVector& f) const
{
    f = ElementVector::Zero(static_cast<Eigen::Index>(2 * nodes_.size()));
    for (const EdgeLoad& load : loads.edge_loads)
        for (const Point& point : points_) {
            const Eigen::Vector2d push = point.area * load.traction(point.place);
            for (Eigen::Index i = 0; i < point.N.size(); ++i) f.segment<2>(2 * i) += point.N[i] * push;
        }
}

Eigen::MatrixXd FoundationElement::strains() const
{
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(2 * points_.size()),
                                                static_cast<Eigen::Index>(2 * nodes_.size()));
    for (Eigen::Index row = 0; const Point& point : points_) {
        const Eigen::Matrix2d k = point.k / point.k.norm();
        for (Eigen::Index i = 0; i < point.N.size(); ++i) all.block<2, 2>(row, 2 * i) = point.N[i] * k;
        row += 2;
    }
    return all;
}

} // namespace femoop
