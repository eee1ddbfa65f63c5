#pragma once

#include <Eigen/Core>
#include <vector>

#include "femoop/element/continuum/continuum_load.h"
#include "femoop/element/element.h"
#include "femoop/shape/shape.h"

namespace femoop {

/// Springs that hold an edge of a body all along, or one of its nodes.
///
///      o---------o---------o      K = integral of N' k N over the area of the edge's face
///      |  |  |  |  |  |  |
///      / / / / / / / / / /        k [2 x 2], force per area and displacement; of a node force per displacement
///
/// An edge load is what the springs push with while the body rests: k times the displacement of their ground.
class FoundationElement final : public Element {
public:
    /// A place where the springs are summed up.
    struct Point {
        Shape::Values N;   ///< of the nodes; 1 of a single one
        double area = 1.0; ///< that it stands for
        Eigen::Matrix2d k; ///< global axes, symmetric
        EdgePoint place;
    };
    FoundationElement(std::vector<NodeId> nodes, std::vector<Point> points);

    ElementDofs dofs() const override;
    void stiffness(ElementMatrix& K) const override;
    void equivalent_forces(const ElementLoads& loads, ElementVector& f) const override;
    Eigen::MatrixXd strains() const override;

private:
    std::vector<NodeId> nodes_;
    std::vector<Point> points_;
};

} // namespace femoop
