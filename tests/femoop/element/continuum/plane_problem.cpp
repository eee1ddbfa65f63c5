#include "tests/femoop/element/continuum/plane_problem.h"

#include <Eigen/Dense>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "femoop/element/continuum/element_geometry.h"
#include "femoop/solver/block_graph.h"
#include "femoop/solver/symmetric_solver.h"
#include "femoop/solver/system_pattern.h"

using namespace femoop;

namespace femoop_test {

namespace {

/// The equations of a problem's nodes.
class Numbering {
public:
    Numbering(const PlaneMesh& mesh, const std::function<bool(NodeId, Dof)>& is_free)
    {
        BlockGraph graph;
        for (std::size_t i = 0; i < mesh.positions.size(); ++i)
            graph.block_sizes.push_back(int(is_free(NodeId(i), Dof::ux)) + int(is_free(NodeId(i), Dof::uy)));
        for (const std::vector<NodeId>& element : mesh.elements) {
            std::vector<std::int32_t> blocks;
            for (const NodeId node : element) blocks.push_back(static_cast<std::int32_t>(node.index));
            graph.add_clique(blocks);
        }
        pattern.emplace(graph, SolverKind::Automatic);
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            std::int32_t next = pattern->first_equation(i);
            for (const Dof dof : {Dof::ux, Dof::uy})
                equations.push_back(is_free(NodeId(i), dof) ? next++ : SystemPattern::none);
        }
    }
    std::vector<std::int32_t> of(const ElementDofs& dofs) const
    {
        std::vector<std::int32_t> found;
        for (const NodeId node : dofs.nodes)
            for (const std::size_t i : {0, 1}) found.push_back(equations[2 * node.index + i]);
        return found;
    }

    std::optional<SystemPattern> pattern;
    std::vector<std::int32_t> equations; ///< two for each node
};

} // namespace

PlaneProblem::PlaneProblem(const PlaneMesh& mesh, const ContinuumFormulation& formulation)
    : mesh_(mesh), edge_loads_(mesh.elements.size()), u_(Eigen::VectorXd::Zero(2 * Eigen::Index(mesh.positions.size())))
{
    for (const std::vector<NodeId>& nodes : mesh.elements)
        elements_.push_back(make_continuum_element(formulation, nodes, mesh.positions));
}

void PlaneProblem::prescribe(const Field& displacement, const std::function<bool(const Eigen::Vector2d&)>& where)
{
    for (std::size_t i = 0; i < mesh_.positions.size(); ++i) {
        if (!where(mesh_.positions[i])) continue;
        const Eigen::Vector2d u = displacement(mesh_.positions[i]);
        prescribe(NodeId(i), Dof::ux, u.x());
        prescribe(NodeId(i), Dof::uy, u.y());
    }
}

void PlaneProblem::pull(const std::function<Eigen::Vector2d(const EdgePoint&)>& traction,
                        const std::function<bool(const Eigen::Vector2d&)>& where)
{
    const Shape& shape = shape_of(mesh_.shape);
    for (const auto& [element, edge] : boundary(mesh_)) {
        const Shape::Edge ends = shape.edges()[static_cast<std::size_t>(edge)];
        const auto position = [&, e = element](int i) {
            return mesh_.positions[mesh_.elements[e][static_cast<std::size_t>(i)].index];
        };
        if (where(0.5 * (position(ends[0]) + position(ends[1])))) edge_loads_[element].push_back({edge, traction});
    }
}

void PlaneProblem::pull_inside(const Field& force) { body_loads_.push_back({force}); }

const Eigen::VectorXd& PlaneProblem::solve()
{
    const Numbering numbering(mesh_, [&](NodeId node, Dof dof) { return !prescribed_.contains({node, dof}); });
    for (const auto& [where, value] : prescribed_) u_[2 * where.first.index + static_cast<int>(where.second)] = value;
    SparseMatrix K = numbering.pattern->matrix();
    Eigen::VectorXd f = Eigen::VectorXd::Zero(K.rows());
    ElementMatrix Ke;
    ElementVector fe;
    for (std::size_t e = 0; e < elements_.size(); ++e) {
        const Element& element = *elements_[e];
        const std::vector<std::int32_t> equations = numbering.of(element.dofs());
        element.stiffness(Ke);
        element.equivalent_forces({.edge_loads = edge_loads_[e], .body_loads = body_loads_}, fe);
        fe -= Ke * displacements_of(e);
        numbering.pattern->add(K, e, equations, Ke);
        for (std::size_t i = 0; i < equations.size(); ++i)
            if (equations[i] != SystemPattern::none) f[equations[i]] += fe[static_cast<int>(i)];
    }
    const auto solver = make_solver(numbering.pattern->solver());
    solver->analyse(*numbering.pattern);
    if (!solver->factorize(K).is_complete) throw std::runtime_error("PlaneProblem: not held");
    const Eigen::VectorXd x = solver->solve(f);
    for (std::size_t i = 0; i < numbering.equations.size(); ++i)
        if (const std::int32_t equation = numbering.equations[i]; equation != SystemPattern::none)
            u_[static_cast<Eigen::Index>(i)] = x[equation];
    return u_;
}

ElementVector PlaneProblem::displacements_of(std::size_t element) const
{
    const std::span<const NodeId> nodes = elements_[element]->dofs().nodes;
    ElementVector u(2 * nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) u.segment<2>(2 * Eigen::Index(i)) = displacement(nodes[i]);
    return u;
}

double PlaneProblem::strain_energy() const
{
    double twice = 0.0;
    ElementMatrix K;
    for (std::size_t e = 0; e < elements_.size(); ++e) {
        const ElementVector u = displacements_of(e);
        elements_[e]->stiffness(K);
        twice += u.dot(K * u);
    }
    return 0.5 * twice;
}

void PlaneProblem::at_integration_points(const std::function<void(std::size_t, const IntegrationPoint&)>& visit) const
{
    for (std::size_t e = 0; e < elements_.size(); ++e)
        for (const IntegrationPoint& point : elements_[e]->formulation().rule().points) visit(e, point);
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
            const StressVector error = problem.element(e).stress(problem.displacements_of(e), at) - exact;
            double volume = weight * jacobian(formulation.shape().derivatives(at), X).determinant();
            if (formulation.state() == StressState::Axisymmetric) volume *= place.x();
            of_error += volume * error.dot(C * error);
            of_exact += volume * exact.dot(C * exact);
        }
    }
    return std::sqrt(of_error / of_exact);
}

} // namespace femoop_test
