#pragma once

#include <Eigen/Core>
#include <functional>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "femoop/element/continuum/continuum_element.h"
#include "tests/femoop/element/continuum/plane_mesh.h"

namespace femoop_test {

/// A body of elements with what is prescribed on it; solved with the same pattern and solver as frames.
class PlaneProblem {
public:
    using Field = std::function<Eigen::Vector2d(const Eigen::Vector2d&)>;

    PlaneProblem(const PlaneMesh& mesh, const femoop::ContinuumFormulation& formulation);

    void prescribe(femoop::NodeId node, femoop::Dof dof, double value) { prescribed_[{node, dof}] = value; }
    void prescribe(const Field& displacement, const std::function<bool(const Eigen::Vector2d&)>& where);
    /// On every edge of the boundary whose middle lies there.
    void pull(const std::function<Eigen::Vector2d(const femoop::EdgePoint&)>& traction,
              const std::function<bool(const Eigen::Vector2d&)>& where);
    void pull_inside(const Field& force);

    const Eigen::VectorXd& solve(); ///< (ux, uy) of every node
    Eigen::Vector2d displacement(femoop::NodeId node) const { return u_.segment<2>(2 * node.index); }
    double strain_energy() const;

    const femoop::ContinuumElement& element(std::size_t i) const { return *elements_[i]; }
    std::size_t n_elements() const { return elements_.size(); }
    femoop::ElementVector displacements_of(std::size_t element) const;

    /// Calls visit(element, natural point) at the integration points of every element.
    void at_integration_points(const std::function<void(std::size_t, const femoop::IntegrationPoint&)>& visit) const;

private:
    const PlaneMesh& mesh_;
    std::vector<std::unique_ptr<femoop::ContinuumElement>> elements_;
    std::map<std::pair<femoop::NodeId, femoop::Dof>, double> prescribed_;
    std::vector<std::vector<femoop::EdgeLoad>> edge_loads_;
    std::vector<femoop::BodyLoad> body_loads_;
    Eigen::VectorXd u_;
};

/// Square root of twice the energy of stress - exact stress, over that of the exact one: the error in energy.
/// \pre the material is linear
double energy_error(const PlaneProblem& problem,
                    const std::function<femoop::StressVector(const Eigen::Vector2d&)>& exact_stress);

} // namespace femoop_test
