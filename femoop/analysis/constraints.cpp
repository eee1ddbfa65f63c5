#include "femoop/analysis/constraints.h"

#include <cmath>
#include <utility>

#include "femoop/element/analysis_model.h"

namespace femoop {

namespace {

/// Imposed strain and curvature of a member in every load case, [cases x 2].
Eigen::MatrixXd imposed(MemberId member, const std::vector<CaseLoads>& loads)
{
    Eigen::MatrixXd strains = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(loads.size()), 2);
    for (std::size_t c = 0; c < loads.size(); ++c)
        for (const SpanLoad& load : loads[c].of(member))
            if (load.kind == SpanLoad::Kind::Strain)
                strains.row(static_cast<Eigen::Index>(c)) += Eigen::RowVector2d(load.start, load.end);
    return strains;
}

/// One row of a member's constraint: terms of unknowns, and in `value` what supports prescribe.
ConstraintRow over_unknowns(const Eigen::RowVectorXd& c, std::span<const std::int32_t> equations,
                            const std::vector<ElementVector>& prescribed, Eigen::VectorXd imposed)
{
    ConstraintRow row{.terms = {}, .value = std::move(imposed), .member = {}};
    const double negligible = 1e-14 * c.cwiseAbs().maxCoeff();
    for (Eigen::Index j = 0; j < c.size(); ++j) {
        if (std::abs(c[j]) <= negligible) continue;
        if (const std::int32_t unknown = equations[static_cast<std::size_t>(j)]; unknown != Equations::none) {
            row.terms.push_back({unknown, c[j]});
            continue;
        }
        for (std::size_t k = 0; k < prescribed.size(); ++k)
            row.value[static_cast<Eigen::Index>(k)] -= c[j] * prescribed[k][j];
    }
    return row;
}

/// Displacements that supports prescribe of a member's degrees of freedom, in every load case.
std::vector<ElementVector> prescribed(const Assembler& assembler, std::size_t member,
                                      const std::vector<std::vector<double>>& settlements)
{
    std::vector<ElementVector> all;
    for (const std::vector<double>& moved : settlements) all.push_back(assembler.prescribed(member, moved));
    return all;
}

/// Makes translations and rotations comparable: a rotation counts as the displacement that it gives over a typical
/// member.
Eigen::VectorXd typical_displacements(const Discretisation& structure, const Equations& equations)
{
    Eigen::VectorXd scale = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(equations.n_unknowns()));
    double length = 0.0;
    for (std::size_t i = 0; i < structure.members.size(); ++i) length += structure.geometry(MemberId(i)).length;
    const double typical = length / static_cast<double>(structure.members.size());
    const auto count_as_rotation = [&](std::int32_t row) {
        if (row != Equations::none) scale[row] = 1.0 / typical;
    };
    const std::span<const Dof> dofs = model_dofs(structure.kind);
    for (std::size_t node = 0; node < structure.positions.size(); ++node)
        for (std::size_t i = 0; i < dofs.size(); ++i)
            if (is_rotation(dofs[i])) count_as_rotation(equations.of(NodeId(node), i));
    for (std::size_t i = 0; i < equations.n_member_end_dofs(); ++i)
        if (is_rotation(static_cast<LocalAxis>(i % n_local_axes))) count_as_rotation(equations.member_end(i));
    return scale;
}

} // namespace

std::vector<ConstraintRow> constraint_rows(const Assembler& assembler, const std::vector<CaseLoads>& loads)
{
    std::vector<std::vector<double>> settlements;
    for (const CaseLoads& each : loads) settlements.push_back(assembler.settlements(each));
    std::vector<ConstraintRow> rows;
    for (std::size_t i = 0; i < assembler.structure().members.size(); ++i) {
        const StraightMember& member = assembler.elements()[MemberId(i)];
        if (!member.is_constrained()) continue;
        const StraightMember::ConstraintRows own = member.constraint_rows();
        const Eigen::MatrixXd C = assembler.in_node_axes(i, own.C);
        const Eigen::MatrixXd strains = imposed(MemberId(i), loads);
        const std::vector<ElementVector> moved = prescribed(assembler, i, settlements);
        for (Eigen::Index r = 0; r < C.rows(); ++r) {
            rows.push_back(over_unknowns(C.row(r), assembler.equations().of_element(i), moved,
                                         own.strain[r] * strains.col(0) + own.curvature[r] * strains.col(1)));
            rows.back().member = MemberId(i);
        }
    }
    return rows;
}

Elimination eliminate_constraints(const Assembler& assembler, const std::vector<CaseLoads>& loads)
{
    const Equations& equations = assembler.equations();
    return eliminate(constraint_rows(assembler, loads), equations.n_unknowns(), loads.size(),
                     typical_displacements(assembler.structure(), equations));
}

} // namespace femoop
