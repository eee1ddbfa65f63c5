#include "femoop/analysis/compatibility.h"

#include <cmath>
#include <cstdint>

namespace femoop {

namespace {

constexpr double strainless = 1e-8; // of the largest turn: what bent rods, drawn straight, leave is more
constexpr double rounding = 1e-13;  // of the terms of a strain that cancel
constexpr double no_energy = 1e-14; // of the scaled A' A: a free motion leaves less

/// Rows of a sparse matrix over all unknowns, one after the other.
class RowList {
public:
    void add(std::span<const std::int32_t> equations, const Eigen::MatrixXd& rows)
    {
        for (Eigen::Index r = 0; r < rows.rows(); ++r, ++n_rows_)
            for (std::size_t j = 0; j < equations.size(); ++j)
                if (const double a = rows(r, static_cast<Eigen::Index>(j)); a != 0.0 && equations[j] != Equations::none)
                    entries_.emplace_back(n_rows_, equations[j], a);
    }
    void add(std::int32_t equation, double value)
    {
        if (equation != Equations::none) entries_.emplace_back(n_rows_++, equation, value);
    }

    Eigen::SparseMatrix<double, Eigen::RowMajor> matrix(std::size_t n_unknowns) const
    {
        Eigen::SparseMatrix<double, Eigen::RowMajor> A(n_rows_, static_cast<Eigen::Index>(n_unknowns));
        A.setFromTriplets(entries_.begin(), entries_.end());
        return A;
    }

private:
    std::vector<Eigen::Triplet<double>> entries_;
    int n_rows_ = 0;
};

template <AnalysisKind kind> using Element = typename Assembly<kind>::Element;

/// Displacements of a member's ends from those of its nodes, [2m x 2n].
template <AnalysisKind kind> Eigen::MatrixXd end_transformation(const Element<kind>& element)
{
    constexpr int m = Element<kind>::m, n = Element<kind>::n;
    Eigen::MatrixXd T = Eigen::MatrixXd::Zero(2 * m, 2 * n);
    T.topLeftCorner(m, n) = element.transformation(0);
    T.bottomRightCorner(m, n) = element.transformation(1);
    return T;
}

Eigen::MatrixXd stacked(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
    Eigen::MatrixXd both(a.rows() + b.rows(), a.cols());
    both << a, b;
    return both;
}

/// What strains the springs between nodes and ends; releases are not strained.
Eigen::MatrixXd sprung_gaps(const Eigen::MatrixXd& gaps, const Eigen::VectorXd& joints)
{
    Eigen::MatrixXd rows(0, gaps.cols());
    for (Eigen::Index i = 0; i < gaps.rows(); ++i)
        if (joints[i] > 0.0) rows = stacked(rows, gaps.row(i));
    return rows;
}

/// How a member's chord swings, from the displacements of its nodes.
template <AnalysisKind kind> Eigen::MatrixXd swings(const Element<kind>& element, double L)
{
    constexpr int n = Element<kind>::n;
    Eigen::MatrixXd rows(3, 2 * n);
    for (const LocalAxis axis : {LocalAxis::x, LocalAxis::y, LocalAxis::z})
        rows.row(static_cast<Eigen::Index>(index(axis))) << -element.transformation_row(0, axis) / L,
            element.transformation_row(1, axis) / L;
    return rows;
}

} // namespace

template <AnalysisKind kind>
MemberStrains member_strains(const Discretisation& structure, const Assembly<kind>& assembly, MemberId member)
{
    const MemberGeometry geometry = structure.geometry(member);
    const Element<kind> elastic = assembly.element(member, geometry);
    const MemberEndConditions* end_conditions = structure.end_conditions_of(member);
    if (end_conditions == nullptr || end_conditions->constraint == Constraint::None) {
        const auto rows = assembly.node_equations(member);
        return {.equations = {rows.begin(), rows.end()}, .A = elastic.strains().B * end_transformation<kind>(elastic)};
    }
    const Element<kind> constrained = assembly.unit_element(member, geometry, constrained_actions(*end_conditions));
    auto own = assembly.member_ends(member, elastic);
    const Eigen::MatrixXd strains = stacked(elastic.rigid_joint_strains().B, constrained.rigid_joint_strains().B);
    return {.equations = std::move(own.equations), .A = stacked(strains * own.B, sprung_gaps(own.gaps, own.joints))};
}

template <AnalysisKind kind>
SparseMatrix resistance(const Discretisation& structure, const Equations& equations, const Assembly<kind>& assembly)
{
    SparseMatrix found = equations.pattern().matrix();
    for (std::size_t i = 0; i < structure.members.size(); ++i) {
        const MemberGeometry geometry = structure.geometry(MemberId(i));
        for (const Element<kind>& element : assembly.resisting_elements(MemberId(i), geometry)) {
            const Eigen::MatrixXd A = element.strains().B * end_transformation<kind>(element);
            equations.pattern().add(found, i, assembly.node_equations(MemberId(i)), (A.transpose() * A).eval());
        }
    }
    for (const Discretisation::SupportRow& support : structure.supports)
        for (std::size_t i = 0; i < model_dofs(kind).size(); ++i)
            if (const std::int32_t row = equations.of(support.node, i);
                row != Equations::none && support.springs[index(model_dofs(kind)[i])] > 0.0)
                equations.pattern().add_to_diagonal(found, row, 1.0);
    return found;
}

template <AnalysisKind kind>
Compatibility Compatibility::of(const Discretisation& structure, const Equations& equations,
                                const Assembly<kind>& assembly, const ArtificialRestraints& restraints)
{
    RowList strains, turns;
    for (std::size_t i = 0; i < structure.members.size(); ++i) {
        const MemberId member(i);
        const MemberStrains own = member_strains(structure, assembly, member);
        strains.add(own.equations, own.A);
        const MemberGeometry geometry = structure.geometry(member);
        turns.add(assembly.node_equations(member), swings<kind>(assembly.element(member, geometry), geometry.length));
    }
    const double size = structure.size();
    const std::span<const Dof> dofs = model_dofs(kind);
    const auto unit = [&](Dof dof) { return is_rotation(dof) ? 1.0 : 1.0 / size; };
    for (const Discretisation::SupportRow& support : structure.supports)
        for (std::size_t i = 0; i < dofs.size(); ++i)
            if (support.springs[index(dofs[i])] > 0.0) strains.add(equations.of(support.node, i), unit(dofs[i]));
    for (std::size_t node = 0; node < structure.positions.size(); ++node)
        for (std::size_t i = 0; i < dofs.size(); ++i) turns.add(equations.of(NodeId(node), i), unit(dofs[i]));
    for (std::size_t i = 0; i < equations.n_member_end_dofs(); ++i)
        turns.add(equations.member_end(i), is_rotation(static_cast<LocalAxis>(i % n_local_axes)) ? 1.0 : 1.0 / size);
    for (const ArtificialRestraint& rotation : restraints.rotations) {
        std::vector<std::int32_t> rows;
        for (const ArtificialRestraint::Part& part : rotation.parts)
            if (part.node == rotation.parts.front().node) rows.push_back(part.row);
        strains.add(rows, rotation.direction.head(static_cast<Eigen::Index>(rows.size())).transpose());
    }
    for (const MemberEndRestraint& end : restraints.member_ends) strains.add(end.equation, 1.0);

    Compatibility compatibility;
    compatibility.strains_ = strains.matrix(equations.n_unknowns());
    compatibility.magnitudes_ = compatibility.strains_.cwiseAbs();
    compatibility.turns_ = turns.matrix(equations.n_unknowns());
    return compatibility;
}

NullModes Compatibility::free_motions(Eigen::Index most) const
{
    return null_modes(strains_, no_energy, most, [this](const Eigen::VectorXd& x) { return is_free(x); });
}

bool Compatibility::is_free(const Eigen::VectorXd& x) const
{
    const Eigen::ArrayXd strain = (strains_ * x).cwiseAbs();
    const Eigen::ArrayXd terms = magnitudes_ * x.cwiseAbs();
    const double turn = (turns_ * x).cwiseAbs().maxCoeff();
    return (strain <= strainless * turn + rounding * terms).all();
}

template MemberStrains member_strains(const Discretisation&, const Assembly<AnalysisKind::Truss2d>&, MemberId);
template MemberStrains member_strains(const Discretisation&, const Assembly<AnalysisKind::Frame2d>&, MemberId);
template MemberStrains member_strains(const Discretisation&, const Assembly<AnalysisKind::Grillage>&, MemberId);
template MemberStrains member_strains(const Discretisation&, const Assembly<AnalysisKind::Truss3d>&, MemberId);
template MemberStrains member_strains(const Discretisation&, const Assembly<AnalysisKind::Frame3d>&, MemberId);
template SparseMatrix resistance(const Discretisation&, const Equations&, const Assembly<AnalysisKind::Truss2d>&);
template Compatibility Compatibility::of(const Discretisation&, const Equations&,
                                         const Assembly<AnalysisKind::Truss2d>&, const ArtificialRestraints&);
template SparseMatrix resistance(const Discretisation&, const Equations&, const Assembly<AnalysisKind::Frame2d>&);
template Compatibility Compatibility::of(const Discretisation&, const Equations&,
                                         const Assembly<AnalysisKind::Frame2d>&, const ArtificialRestraints&);
template SparseMatrix resistance(const Discretisation&, const Equations&, const Assembly<AnalysisKind::Grillage>&);
template Compatibility Compatibility::of(const Discretisation&, const Equations&,
                                         const Assembly<AnalysisKind::Grillage>&, const ArtificialRestraints&);
template SparseMatrix resistance(const Discretisation&, const Equations&, const Assembly<AnalysisKind::Truss3d>&);
template Compatibility Compatibility::of(const Discretisation&, const Equations&,
                                         const Assembly<AnalysisKind::Truss3d>&, const ArtificialRestraints&);
template SparseMatrix resistance(const Discretisation&, const Equations&, const Assembly<AnalysisKind::Frame3d>&);
template Compatibility Compatibility::of(const Discretisation&, const Equations&,
                                         const Assembly<AnalysisKind::Frame3d>&, const ArtificialRestraints&);

} // namespace femoop
