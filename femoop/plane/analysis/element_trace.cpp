#include "femoop/plane/analysis/element_trace.h"

#include <cmath>
#include <cstddef>
#include <numbers>

#include "femoop/algebra/congruence.h"
#include "femoop/element/continuum/element_geometry.h"
#include "femoop/plane/analysis/plane_structure.h"
#include "femoop/plane/mesh/mesh_geometry.h"

namespace femoop::plane {

namespace {

std::vector<std::string> strain_names(StressState state)
{
    if (state == StressState::PlaneStress) return {"ex", "ey", "gxy"};
    return {"ex", "ey", "ez", "gxy"};
}

/// The equation of each displacement, as one numbers them on paper: node after node, ux before uy.
std::vector<int> equations_of_all(const Discretisation& structure)
{
    std::vector<int> equations(2 * structure.positions.size(), 0);
    std::vector<bool> follows(equations.size());
    const auto row = [](NodeId node, Dof dof) { return 2 * std::size_t{node.index} + (dof == Dof::ux ? 0 : 1); };
    for (const Discretisation::Tie& tie : structure.ties) follows[row(tie.node, tie.dof)] = true;
    int n = 0;
    for (std::size_t i = 0; i < structure.positions.size(); ++i)
        for (const Dof dof : {Dof::ux, Dof::uy}) {
            const NodeId node(i);
            const Discretisation::SupportRow* support = structure.support_of(node);
            const bool is_held = support != nullptr && support->blocked.contains(dof);
            if (structure.is_attached[i] && !is_held && !follows[row(node, dof)]) equations[row(node, dof)] = ++n;
        }
    for (const Discretisation::Tie& tie : structure.ties)
        equations[row(tie.node, tie.dof)] = equations[row(tie.leader, tie.dof)];
    return equations;
}

/// From the axes of the nodes to the global ones; empty where they are the same.
Eigen::MatrixXd turned_axes(const Discretisation& structure, const std::vector<NodeId>& nodes)
{
    const auto n = static_cast<Eigen::Index>(2 * nodes.size());
    Eigen::MatrixXd T = Eigen::MatrixXd::Identity(n, n);
    bool is_turned = false;
    for (Eigen::Index i = 0; const NodeId node : nodes) {
        const Discretisation::SupportRow* support = structure.support_of(node);
        if (support != nullptr && support->angle != 0.0) {
            const double c = std::cos(support->angle), s = std::sin(support->angle);
            T.block<2, 2>(i, i) << c, -s, s, c;
            is_turned = true;
        }
        i += 2;
    }
    return is_turned ? T : Eigen::MatrixXd();
}

} // namespace

ElementTrace trace(const PlaneModel& model, ElementId id)
{
    const PlaneStructure structure(model);
    const PlaneElement& element = model[id];
    const ContinuumElement& traced = structure.element(id);
    const ContinuumFormulation& formulation = traced.formulation();
    const StressState state = model.analysis;
    ElementTrace found{.element = element.id,
                       .region = model[element.region].id,
                       .kind = element.kind,
                       .formulation = model.formulation(element.region),
                       .components = strain_names(state)};
    const std::vector<int> equations = equations_of_all(*structure.discretisation());
    for (const NodeId node : element.points) {
        found.nodes.push_back(model[node].id);
        for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
            found.dofs.push_back(model[node].id + (i == 0 ? ".ux" : ".uy"));
            found.equations.push_back(equations[2 * node.index + i]);
        }
    }
    found.D = formulation.material().tangent({.strain = StrainVector::Zero(n_components(state))});
    const NodePositions X = positions_of(model, element);
    const Eigen::MatrixXd all = traced.strains();
    for (Eigen::Index row = 0; const ShapeAtPoint& point : formulation.points()) {
        ElementTrace::Point& at = found.points.emplace_back();
        at.natural = point.at;
        at.weight = point.weight;
        at.at = traced.place(point.at);
        at.N = point.N;
        at.J = jacobian(point.dN, X);
        at.area = at.J.determinant();
        at.depth = traced.volume(point.at) / at.area;
        at.B = all.middleRows(row, found.D.rows());
        at.part = congruence(point.weight * at.area * at.depth * found.D, at.B);
        row += found.D.rows();
    }
    ElementMatrix K;
    traced.stiffness(K);
    found.stiffness = K;
    if (const Eigen::MatrixXd T = turned_axes(*structure.discretisation(), element.points); T.size() > 0)
        found.to_nodes = congruence(found.stiffness, T);
    const std::vector<CaseLoads> loads = structure.loads();
    for (std::size_t c = 0; c < loads.size(); ++c)
        for (const CaseLoads::OnElement& on : loads[c].elements) {
            if (on.element != id.index) continue;
            ElementVector f;
            traced.equivalent_forces(on.loads(), f);
            found.loads.push_back({.load_case = model.load_cases[c].id, .f = f});
        }
    return found;
}

} // namespace femoop::plane
