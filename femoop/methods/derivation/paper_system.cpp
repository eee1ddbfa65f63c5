#include "femoop/methods/derivation/paper_system.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <set>

#include "femoop/element/analysis_model.h"
#include "femoop/result/curve_reader.h"

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

PaperSystem::PaperSystem(const Model& model)
    : model_(model), structure_(discretise(model)), trace_(trace_system(model)), solved_(trace_.solved_matrix())
{}

std::optional<Eigen::Index> PaperSystem::row_of(NodeId node, Dof dof) const
{
    const auto is_it = [&](const SystemTrace::Unknown& one) {
        return one.node == node && one.dof == dof && !one.end_of;
    };
    const auto found = std::ranges::find_if(trace_.unknowns, is_it);
    if (found == trace_.unknowns.end()) return std::nullopt;
    return found - trace_.unknowns.begin();
}

std::string PaperSystem::name_of(Eigen::Index row) const
{
    return unknown_name(model_, trace_.unknowns[static_cast<std::size_t>(row)]);
}

std::vector<std::string> PaperSystem::names_of(const std::vector<Eigen::Index>& rows) const
{
    std::vector<std::string> names;
    std::ranges::transform(rows, std::back_inserter(names), [this](Eigen::Index row) { return name_of(row); });
    return names;
}

std::vector<Eigen::Index> PaperSystem::all_rows() const
{
    std::vector<Eigen::Index> rows(trace_.unknowns.size());
    std::iota(rows.begin(), rows.end(), Eigen::Index{0});
    return rows;
}

std::vector<Eigen::Index> PaperSystem::written_rows(const std::vector<Eigen::Index>& rows) const
{
    return has_few_unknowns() ? all_rows() : rows;
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
    CurveReader reader(result);
    for (std::size_t i = 0; i < trace_.unknowns.size(); ++i) {
        const auto& [node, dof, member] = trace_.unknowns[i];
        const auto row = static_cast<Eigen::Index>(i);
        if (member) {
            const std::size_t end = model_[*member].nodes.front() == node ? 0 : 1;
            u[row] = reader.end_displacements(*member)[end][index(dof)];
            continue;
        }
        const auto place = std::ranges::find(dofs, dof) - dofs.begin();
        u[row] = in_node_axes(node, result.displacement(node))[place];
    }
    return u;
}

std::vector<Eigen::Index> PaperSystem::solved_rows(const std::vector<Eigen::Index>& rows) const
{
    if (!trace_.ties) return rows;
    std::set<Eigen::Index> solved;
    const Eigen::SparseMatrix<double, Eigen::RowMajor> G = trace_.ties->G;
    for (const Eigen::Index row : rows)
        for (decltype(G)::InnerIterator entry(G, row); entry; ++entry) solved.insert(entry.col());
    return {solved.begin(), solved.end()};
}

std::vector<std::string> PaperSystem::solved_names(const std::vector<Eigen::Index>& solved) const
{
    if (!trace_.ties) return names_of(solved);
    std::vector<Eigen::Index> rows;
    for (const Eigen::Index each : solved) rows.push_back(trace_.ties->independent[static_cast<std::size_t>(each)]);
    return names_of(rows);
}

namespace {

std::vector<Eigen::Index> coupled_columns(const SparseMatrix& K, const std::vector<Eigen::Index>& rows)
{
    std::set<Eigen::Index> columns;
    for (const Eigen::Index row : rows)
        for (SparseMatrix::InnerIterator entry(K, row); entry; ++entry) // K is symmetric
            if (entry.value() != 0.0 || entry.row() == row) columns.insert(entry.row());
    return {columns.begin(), columns.end()};
}

} // namespace

std::vector<Eigen::Index> PaperSystem::coupled_with(Eigen::Index row) const { return coupled_columns(trace_.K, {row}); }

std::vector<NamedMatrix> PaperSystem::equations(const std::vector<Eigen::Index>& of, CaseId load_case,
                                                const CaseResult& result) const
{
    std::vector<Eigen::Index> rows = solved_rows(of), columns;
    if (is_written_whole()) {
        rows.resize(static_cast<std::size_t>(solved_.rows()));
        std::iota(rows.begin(), rows.end(), Eigen::Index{0});
        columns = rows;
    } else columns = coupled_columns(solved_, rows);
    Eigen::MatrixXd K(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(columns.size()));
    for (Eigen::Index i = 0; i < K.rows(); ++i)
        for (Eigen::Index j = 0; j < K.cols(); ++j)
            K(i, j) = solved_.coeff(rows[static_cast<std::size_t>(i)], columns[static_cast<std::size_t>(j)]);
    Eigen::VectorXd u = unknowns_in(result), f = trace_.f.col(load_case.index);
    const auto& ties = trace_.ties;
    if (ties) {
        f = Eigen::VectorXd(ties->G.transpose() * (f - trace_.K * ties->u0.col(load_case.index)));
        u = Eigen::VectorXd(u(ties->independent));
    }
    const Eigen::VectorXd shown_u = u(columns), shown_f = f(rows);
    return {{ties ? "G^T K G" : "K", solved_names(rows), solved_names(columns), K},
            {ties ? "y" : "u", solved_names(columns), {ties ? "y" : "u"}, shown_u},
            {ties ? "G^T (f - K u0)" : "f", solved_names(rows), {ties ? "G^T (f - K u0)" : "f"}, shown_f}};
}

} // namespace femoop::derivation
