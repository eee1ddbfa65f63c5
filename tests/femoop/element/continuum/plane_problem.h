#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "femoop/discretisation/case_loads.h"
#include "femoop/discretisation/discretisation.h"
#include "femoop/discretisation/elements.h"
#include "femoop/element/continuum/continuum_element.h"
#include "femoop/result/element_field.h"
#include "tests/femoop/element/continuum/plane_mesh.h"

namespace femoop_test {

using Vector = Eigen::Vector2d;

inline constexpr double E = 71.0e3, nu = 0.27, thickness = 0.37; // of all tests here: none 1, no two equal

/// The traction of a stress (in the order of its state) on an edge.
Vector traction(const femoop::StressVector& stress, const femoop::EdgePoint& edge);
inline bool everywhere(const Vector&) { return true; }

/// A body of elements with what is prescribed on it; solved by the assembler and the solver that frames have.
class PlaneProblem {
public:
    using Field = std::function<Eigen::Vector2d(const Eigen::Vector2d&)>;
    using Place = std::function<bool(const Eigen::Vector2d&)>;

    PlaneProblem(const PlaneMesh& mesh, const femoop::ContinuumFormulation& formulation);

    void prescribe(femoop::NodeId node, femoop::Dof dof, double value);
    /// On every edge of the boundary whose middle lies there.
    void pull(const std::function<Eigen::Vector2d(const femoop::EdgePoint&)>& traction, const Place& where);
    void pull_inside(const Field& force);

    void solve();
    Eigen::Vector2d displacement(femoop::NodeId node) const { return u_.segment<2>(2 * node.index); }
    double strain_energy() const;

    std::size_t n_elements() const { return elements_.size(); }
    const femoop::ContinuumElement& element(std::size_t i) const
    {
        return static_cast<const femoop::ContinuumElement&>(elements_[i]);
    }
    femoop::ElementField field(std::size_t i) const
    {
        return {element(i), {u_.data(), static_cast<std::size_t>(u_.size())}};
    }

    /// Calls visit(element, point) at the integration points of every element.
    void at_integration_points(const std::function<void(std::size_t, const femoop::IntegrationPoint&)>& visit) const;

private:
    const PlaneMesh& mesh_;
    femoop::Discretisation structure_;
    femoop::Elements elements_;
    femoop::CaseLoads loads_;
    Eigen::VectorXd u_; ///< (ux, uy) of every node
};

/// The error in energy: of stress less exact stress, over that of the exact one, its square root.
/// \pre the material is linear
double energy_error(const PlaneProblem& problem,
                    const std::function<femoop::StressVector(const Eigen::Vector2d&)>& exact_stress);

} // namespace femoop_test
