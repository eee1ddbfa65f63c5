#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "femoop/plane/model/plane_model.h"
#include "femoop/shape/shape.h"

namespace femoop::plane {

/// How one element came into the system of equations K u = f: the numbers that a student writes on paper.
struct ElementTrace {
    /// A point of its integration rule.
    struct Point {
        NaturalPoint natural;
        double weight = 0.0;
        Eigen::Vector2d at;   ///< in the plane
        Shape::Values N;      ///< of its nodes there
        Eigen::Matrix2d J;    ///< d(x, y) / d(xi, eta): row xi, row eta
        double area = 0.0;    ///< det J
        double depth = 0.0;   ///< the thickness; of a body of revolution 2 pi r
        Eigen::MatrixXd B;    ///< strain = B u [components x dofs]
        Eigen::MatrixXd part; ///< B' D B weight det J depth
    };
    struct NodalForces {
        std::string load_case;
        Eigen::VectorXd f; ///< what its loads are to its nodes, global axes
    };
    std::string element, region;
    ShapeKind kind = ShapeKind::T3;
    Formulation formulation = Formulation::Standard;
    std::vector<std::string> nodes;
    std::vector<std::string> dofs;       ///< "A.ux", "A.uy", "B.ux", ..
    std::vector<std::string> components; ///< of strain: "ex", "ey", "gxy"; with "ez" where it is one
    Eigen::MatrixXd D;                   ///< stress = D strain
    std::vector<Point> points;
    /// The parts' sum, less what the modes of incompatible elements take. Global axes.
    Eigen::MatrixXd stiffness;
    Eigen::MatrixXd to_nodes;       ///< k in the axes of supports that are turned: T' k T; empty where none is
    std::vector<NodalForces> loads; ///< of the load cases that load it
    std::vector<int> equations;     ///< place of each row in the system, node after node from 1; 0 where it is held
};

/// Traces one element through the same code that solves. \pre `check(model)` finds no error
ElementTrace trace(const PlaneModel& model, ElementId element);

} // namespace femoop::plane
