#include "tests/femoop/element/continuum/plane_problem.h"

#include <Eigen/Dense>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#include "femoop/analysis/assembler.h"
#include "femoop/discretisation/equations.h"
#include "femoop/element/continuum/element_geometry.h"
#include "femoop/solver/symmetric_solver.h"

using namespace femoop;

namespace femoop_test {

namespace {

/// Nodes with ux and uy, as those of a truss, and bodies in place of members.
Discretisation nodes_of(const PlaneMesh& mesh, const ContinuumFormulation& formulation)
{
    Discretisation nodes{.kind = AnalysisKind::Truss2d};
    for (const Eigen::Vector2d& p : mesh.positions) nodes.positions.emplace_back(p.x(), p.y(), 0.0);
    nodes.support_of_node.assign(mesh.positions.size(), -1);
    nodes.is_attached.assign(mesh.positions.size(), true);
    for (const std::vector<NodeId>& of_element : mesh.elements)
        nodes.bodies.push_back(make_continuum_element(formulation, of_element, mesh.positions));
    return nodes;
}

} // namespace

Vector traction(const StressVector& s, const EdgePoint& edge)
{
    const double shear = s[s.size() - 1];
    return {s[0] * edge.outward.x() + shear * edge.outward.y(), shear * edge.outward.x() + s[1] * edge.outward.y()};
}

PlaneProblem::PlaneProblem(const PlaneMesh& mesh, const ContinuumFormulation& formulation)
    : mesh_(mesh),
      structure_(nodes_of(mesh, formulation)),
      elements_(structure_),
      u_(Eigen::VectorXd::Zero(2 * Eigen::Index(mesh.positions.size())))
{}

void PlaneProblem::prescribe(NodeId node, Dof dof, double value)
{
    std::int32_t& support = structure_.support_of_node[node.index];
    if (support < 0) {
        support = static_cast<std::int32_t>(structure_.supports.size());
        structure_.supports.push_back({.node = node, .blocked = {}});
    }
    structure_.supports[static_cast<std::size_t>(support)].blocked.insert(dof);
    CaseLoads::OnNode settlement{.node = node};
    settlement.value[index(dof)] = value;
    loads_.settlements.push_back(settlement);
}

void PlaneProblem::pull(const std::function<Eigen::Vector2d(const EdgePoint&)>& traction, const Place& where)
{
    const Shape& shape = shape_of(mesh_.shape);
    for (const auto& [element, edge] : boundary(mesh_)) {
        const std::vector<NodeId>& nodes = mesh_.elements[element];
        const Shape::Edge ends = shape.edges()[static_cast<std::size_t>(edge)];
        const Eigen::Vector2d a = mesh_.positions[nodes[static_cast<std::size_t>(ends[0])].index];
        const Eigen::Vector2d b = mesh_.positions[nodes[static_cast<std::size_t>(ends[1])].index];
        if (where(0.5 * (a + b)))
            loads_.elements.push_back({.element = element, .edge_loads = {{edge, traction}}, .body_loads = {}});
    }
}

void PlaneProblem::pull_inside(const Field& force)
{
    for (std::size_t e = 0; e < elements_.size(); ++e)
        loads_.elements.push_back({.element = e, .edge_loads = {}, .body_loads = {{force}}});
}

void PlaneProblem::solve()
{
    const Equations equations(structure_, elements_, SolverKind::Automatic);
    const Assembler assembler(structure_, elements_, equations);
    SparseMatrix K = equations.pattern().matrix();
    assembler.add_stiffness(K);
    const auto solver = make_solver(equations.pattern().solver());
    solver->analyse(equations.pattern());
    if (!solver->factorize(K).is_complete) throw std::runtime_error("PlaneProblem: not held");
    const Eigen::VectorXd x = solver->solve(assembler.load_vector<double>(loads_));
    const std::vector<double> moved = assembler.settlements(loads_);
    for (std::size_t i = 0; i < 2 * mesh_.positions.size(); ++i) {
        const std::int32_t equation = equations.of(NodeId(i / 2), i % 2);
        u_[static_cast<Eigen::Index>(i)] = equation == Equations::none ? moved[i] : x[equation];
    }
}

double PlaneProblem::strain_energy() const
{
    double twice = 0.0;
    ElementMatrix K;
    for (std::size_t e = 0; e < elements_.size(); ++e) {
        const ElementField inside = field(e);
        const ElementVector& u = inside.node_displacements();
        elements_[e].stiffness(K);
        twice += u.dot(K * u);
    }
    return 0.5 * twice;
}

void PlaneProblem::at_integration_points(const std::function<void(std::size_t, const IntegrationPoint&)>& visit) const
{
    for (std::size_t e = 0; e < elements_.size(); ++e)
        for (const IntegrationPoint& point : element(e).formulation().rule().points) visit(e, point);
}

double energy_error(const PlaneProblem& problem,
                    const std::function<StressVector(const Eigen::Vector2d&)>& exact_stress)
{
    const ContinuumFormulation& formulation = problem.element(0).formulation();
    const Eigen::MatrixXd C = formulation.material().tangent({}).inverse();
    double of_error = 0.0, of_exact = 0.0;
    for (std::size_t e = 0; e < problem.n_elements(); ++e) {
        const std::span<const NodeId> nodes = problem.element(e).dofs().nodes;
        NodePositions X(nodes.size(), 2);
        for (std::size_t i = 0; i < nodes.size(); ++i)
            X.row(static_cast<int>(i)) = problem.element(e).place(formulation.shape().nodes()[i]);
        for (const auto& [at, weight] : rule_of_degree(formulation.shape().domain(), 9).points) {
            const Eigen::Vector2d place = problem.element(e).place(at);
            const StressVector exact = exact_stress(place);
            const StressVector error = problem.field(e).stress(at) - exact;
            double volume = weight * jacobian(formulation.shape().derivatives(at), X).determinant();
            if (formulation.state() == StressState::Axisymmetric) volume *= place.x();
            of_error += volume * error.dot(C * error);
            of_exact += volume * exact.dot(C * exact);
        }
    }
    return std::sqrt(of_error / of_exact);
}

} // namespace femoop_test
