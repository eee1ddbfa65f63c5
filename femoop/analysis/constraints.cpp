#include "femoop/analysis/constraints.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace femoop {

namespace {

/// The rows of one member's constraint over its local end displacements, and what each equals per unit of strain
/// and of curvature.
struct LocalRows {
    Eigen::MatrixXd C;         ///< [rows x 2m]
    Eigen::VectorXd strain;    ///< length that each row gains per unit of strain
    Eigen::VectorXd curvature; ///< the same per unit of curvature
};

template <AnalysisKind kind> int local_row(LocalAxis axis)
{
    const auto& local = AnalysisModel<kind>::local;
    const auto at = std::find(local.begin(), local.end(), axis);
    return at == local.end() ? -1 : static_cast<int>(at - local.begin());
}

template <AnalysisKind kind> LocalRows local_rows(const MemberEndConditions& end_conditions, double L)
{
    constexpr int m = MemberElement<kind>::m;
    const ActionSet actions = constrained_actions(end_conditions);
    LocalRows rows{.C = Eigen::MatrixXd::Zero(0, 2 * m), .strain = {}, .curvature = {}};
    const auto append = [&](const Eigen::RowVectorXd& c, double strain, double curvature) {
        const Eigen::Index r = rows.C.rows();
        rows.C.conservativeResize(r + 1, Eigen::NoChange);
        rows.strain.conservativeResize(r + 1);
        rows.curvature.conservativeResize(r + 1);
        rows.C.row(r) = c;
        rows.strain[r] = strain;
        rows.curvature[r] = curvature;
    };
    const auto difference = [&](int row) {
        Eigen::RowVectorXd c = Eigen::RowVectorXd::Zero(2 * m);
        c[row] = -1.0;
        c[m + row] = 1.0;
        return c;
    };
    if (const int x = local_row<kind>(LocalAxis::x); x >= 0 && actions.contains(Action::Axial))
        append(difference(x), L, 0.0);
    if (const int rx = local_row<kind>(LocalAxis::rx); rx >= 0 && actions.contains(Action::Torsion))
        append(difference(rx), 0.0, 0.0);
    for (const BendingPlane plane : {BendingPlane::xy, BendingPlane::xz}) {
        const int v = local_row<kind>(force_axis(plane));
        const int phi = local_row<kind>(moment_axis(plane));
        const Action action = plane == BendingPlane::xy ? Action::BendingXY : Action::BendingXZ;
        if (v < 0 || phi < 0 || !actions.contains(action)) continue;
        const double bent = plane == BendingPlane::xy ? 1.0 : 0.0; // temperature bends in x'y' only
        append(difference(phi), 0.0, bent * L);
        Eigen::RowVectorXd chord = difference(v);
        chord[phi] = -moment_sign(plane) * L;
        append(chord, 0.0, 0.5 * bent * L * L);
    }
    return rows;
}

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

template <AnalysisKind kind>
std::vector<ConstraintRow> constraint_rows(const Discretisation& structure, const Assembly<kind>& assembly,
                                           const std::vector<CaseLoads>& loads)
{
    constexpr int n = MemberElement<kind>::n;
    std::vector<std::vector<double>> settlements;
    for (const CaseLoads& each : loads) settlements.push_back(assembly.settlements(each));

    std::vector<ConstraintRow> rows;
    for (std::size_t i = 0; i < structure.members.size(); ++i) {
        const MemberId member(i);
        const MemberEndConditions* end_conditions = structure.end_conditions_of(member);
        if (end_conditions == nullptr || end_conditions->constraint == Constraint::None) continue;
        const MemberGeometry geometry = structure.geometry(member);
        const auto own = assembly.member_ends(member, assembly.element(member, geometry));
        const LocalRows local = local_rows<kind>(*end_conditions, geometry.length);
        const Eigen::MatrixXd C = local.C * own.B;
        const Eigen::MatrixXd strains = imposed(member, loads);
        for (Eigen::Index r = 0; r < C.rows(); ++r) {
            ConstraintRow row{.terms = {},
                              .value = local.strain[r] * strains.col(0) + local.curvature[r] * strains.col(1),
                              .member = member};
            const double negligible = 1e-14 * C.row(r).cwiseAbs().maxCoeff();
            for (Eigen::Index j = 0; j < C.cols(); ++j) {
                if (std::abs(C(r, j)) <= negligible) continue;
                const std::int32_t unknown = own.equations[static_cast<std::size_t>(j)];
                if (unknown != Equations::none) {
                    row.terms.push_back({unknown, C(r, j)});
                    continue;
                }
                const NodeId node = structure.members[i].nodes[static_cast<std::size_t>(j / n)];
                for (std::size_t c = 0; c < settlements.size(); ++c)
                    if (!settlements[c].empty())
                        row.value[static_cast<Eigen::Index>(c)] -=
                            C(r, j) * settlements[c][node.index * n + static_cast<std::size_t>(j % n)];
            }
            rows.push_back(std::move(row));
        }
    }
    return rows;
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

template <AnalysisKind kind>
Elimination eliminate_constraints(const Discretisation& structure, const Equations& equations,
                                  const Assembly<kind>& assembly, const std::vector<CaseLoads>& loads)
{
    return eliminate(constraint_rows<kind>(structure, assembly, loads), equations.n_unknowns(), loads.size(),
                     typical_displacements(structure, equations));
}

template Elimination eliminate_constraints(const Discretisation&, const Equations&,
                                           const Assembly<AnalysisKind::Truss2d>&, const std::vector<CaseLoads>&);
template Elimination eliminate_constraints(const Discretisation&, const Equations&,
                                           const Assembly<AnalysisKind::Frame2d>&, const std::vector<CaseLoads>&);
template Elimination eliminate_constraints(const Discretisation&, const Equations&,
                                           const Assembly<AnalysisKind::Grillage>&, const std::vector<CaseLoads>&);
template Elimination eliminate_constraints(const Discretisation&, const Equations&,
                                           const Assembly<AnalysisKind::Truss3d>&, const std::vector<CaseLoads>&);
template Elimination eliminate_constraints(const Discretisation&, const Equations&,
                                           const Assembly<AnalysisKind::Frame3d>&, const std::vector<CaseLoads>&);

} // namespace femoop
