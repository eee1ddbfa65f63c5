#include "femoop/methods/derivation/paper_system.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "femoop/element/analysis_model.h"

namespace femoop::derivation {

namespace {

/// ux and uy come first where they are known.
void turn(Eigen::VectorXd& v, double angle)
{
    if (angle == 0.0) return;
    const double x = v[0], y = v[1];
    v[0] = std::cos(angle) * x - std::sin(angle) * y;
    v[1] = std::sin(angle) * x + std::cos(angle) * y;
}

} // namespace

PaperSystem::PaperSystem(const Model& model) : model_(model), structure_(discretise(model)), trace_(trace_system(model))
{}

std::optional<Eigen::Index> PaperSystem::row_of(NodeId node, Dof dof) const
{
    const auto is_it = [&](const SystemTrace::Unknown& one) { return one.node == node && one.dof == dof; };
    const auto found = std::ranges::find_if(trace_.unknowns, is_it);
    if (found == trace_.unknowns.end()) return std::nullopt;
    return found - trace_.unknowns.begin();
}

std::string PaperSystem::name_of(Eigen::Index row) const
{
    const SystemTrace::Unknown& unknown = trace_.unknowns[static_cast<std::size_t>(row)];
    return model_[unknown.node].id + "." + std::string(name(unknown.dof));
}

std::vector<Eigen::Index> PaperSystem::coupled_with(Eigen::Index row) const
{
    std::vector<Eigen::Index> others;
    for (SparseMatrix::InnerIterator entry(trace_.K, row); entry; ++entry) // K is symmetric
        if (entry.value() != 0.0 || entry.row() == row) others.push_back(entry.row());
    return others;
}

double PaperSystem::angle_of(NodeId node) const
{
    const Discretisation::SupportRow* support = structure_.support_of(node);
    return support == nullptr ? 0.0 : support->angle;
}

Eigen::VectorXd PaperSystem::in_node_axes(NodeId node, const NodeVector& displacement) const
{
    const std::span<const Dof> dofs = model_dofs(structure_.kind);
    Eigen::VectorXd v(static_cast<Eigen::Index>(dofs.size()));
    for (std::size_t i = 0; i < dofs.size(); ++i) v[static_cast<Eigen::Index>(i)] = displacement[index(dofs[i])];
    turn(v, -angle_of(node));
    return v;
}

Eigen::VectorXd PaperSystem::in_global_axes(NodeId node, Eigen::VectorXd forces) const
{
    turn(forces, angle_of(node));
    return forces;
}

Eigen::VectorXd PaperSystem::unknowns_in(const CaseResult& result) const
{
    const std::span<const Dof> dofs = model_dofs(structure_.kind);
    Eigen::VectorXd u(static_cast<Eigen::Index>(trace_.unknowns.size()));
    for (std::size_t i = 0; i < trace_.unknowns.size(); ++i) {
        const auto [node, dof] = trace_.unknowns[i];
        const auto place = std::ranges::find(dofs, dof) - dofs.begin();
        u[static_cast<Eigen::Index>(i)] = in_node_axes(node, result.displacement(node))[place];
    }
    return u;
}

std::vector<NamedMatrix> PaperSystem::equations(std::vector<Eigen::Index> rows, CaseId load_case,
                                                const CaseResult& result) const
{
    std::vector<Eigen::Index> columns;
    if (is_written_whole()) {
        rows.resize(trace_.unknowns.size());
        std::iota(rows.begin(), rows.end(), Eigen::Index{0});
        columns = rows;
    } else {
        for (const Eigen::Index row : rows) std::ranges::copy(coupled_with(row), std::back_inserter(columns));
        std::ranges::sort(columns);
        columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
    }
    const auto names = [this](const std::vector<Eigen::Index>& of) {
        std::vector<std::string> list;
        std::ranges::transform(of, std::back_inserter(list), [this](Eigen::Index row) { return name_of(row); });
        return list;
    };
    Eigen::MatrixXd K(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(columns.size()));
    for (Eigen::Index i = 0; i < K.rows(); ++i)
        for (Eigen::Index j = 0; j < K.cols(); ++j)
            K(i, j) = trace_.K.coeff(rows[static_cast<std::size_t>(i)], columns[static_cast<std::size_t>(j)]);
    const Eigen::VectorXd u = unknowns_in(result)(columns), f = trace_.f.col(load_case.index)(rows);
    return {{"K", names(rows), names(columns), K}, {"u", names(columns), {"u"}, u}, {"f", names(rows), {"f"}, f}};
}

} // namespace femoop::derivation
