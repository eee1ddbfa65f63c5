#include "femoop/analysis/compatibility.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "femoop/element/analysis_model.h"

namespace femoop {

namespace {

constexpr double strainless = 1e-8;       // of the largest turn: what bent rods, drawn straight, leave is more
constexpr double strain_rounding = 1e-13; // of the terms of a strain that cancel
constexpr double no_energy = 1e-14;       // of the scaled A' A: a free motion leaves less

/// Rows of a sparse matrix over all unknowns, one after the other.
class RowList {
public:
    void add(std::span<const std::int32_t> equations, const Eigen::MatrixXd& rows)
    {
        for (Eigen::Index r = 0; r < rows.rows(); ++r, ++n_rows_)
            for (std::size_t j = 0; j < equations.size(); ++j)
                if (const double a = rows(r, static_cast<Eigen::Index>(j)); a != 0.0) {
                    largest_ = std::max(largest_, std::abs(a));
                    if (equations[j] != Equations::none) entries_.emplace_back(n_rows_, equations[j], a);
                }
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

    double largest_entry() const { return largest_; } ///< of rows over element displacements, left out or not

private:
    std::vector<Eigen::Triplet<double>> entries_;
    int n_rows_ = 0;
    double largest_ = 0.0;
};

/// Counts displacements in the structure's size beside rotations.
class RotationUnit {
public:
    explicit RotationUnit(double size) : size_(size) {}
    double operator()(auto axis) const { return is_rotation(axis) ? 1.0 : 1.0 / size_; }

private:
    double size_;
};

void add_supports(const Assembler& assembler, const RotationUnit& unit, RowList& strains)
{
    const std::span<const Dof> dofs = model_dofs(assembler.structure().kind);
    for (const Discretisation::SupportRow& support : assembler.structure().supports)
        for (std::size_t i = 0; i < dofs.size(); ++i)
            if (support.springs[index(dofs[i])] > 0.0)
                strains.add(assembler.equations().of(support.node, i), unit(dofs[i]));
}

void add_restraints(const ArtificialRestraints& restraints, RowList& strains)
{
    for (const ArtificialRestraint& rotation : restraints.rotations) {
        std::vector<std::int32_t> rows;
        for (const ArtificialRestraint::Part& part : rotation.parts)
            if (part.node == rotation.parts.front().node) rows.push_back(part.row);
        strains.add(rows, rotation.direction.head(static_cast<Eigen::Index>(rows.size())).transpose());
    }
    for (const MemberEndRestraint& end : restraints.member_ends) strains.add(end.equation, 1.0);
}

RowList strains_of(const Assembler& assembler, const ArtificialRestraints& restraints, const RotationUnit& unit)
{
    RowList strains;
    for (std::size_t i = 0; i < assembler.elements().size(); ++i)
        strains.add(assembler.equations().of_element(i), assembler.in_node_axes(i, assembler.elements()[i].strains()));
    add_supports(assembler, unit, strains);
    add_restraints(restraints, strains);
    return strains;
}

/// Of chords of members, of nodes and of members' ends.
RowList turns_of(const Assembler& assembler, const RotationUnit& unit)
{
    RowList turns;
    const Discretisation& structure = assembler.structure();
    const Equations& equations = assembler.equations();
    for (std::size_t i = 0; i < structure.members.size(); ++i) {
        const Eigen::MatrixXd swings = assembler.in_node_axes(i, assembler.elements()[MemberId(i)].chord_rotations());
        turns.add(equations.of_element(i).first(static_cast<std::size_t>(swings.cols())), swings);
    }
    const std::span<const Dof> dofs = model_dofs(structure.kind);
    for (std::size_t node = 0; node < structure.positions.size(); ++node)
        for (std::size_t i = 0; i < dofs.size(); ++i) turns.add(equations.of(NodeId(node), i), unit(dofs[i]));
    for (std::size_t i = 0; i < equations.n_member_end_dofs(); ++i)
        turns.add(equations.member_end(i), unit(static_cast<LocalAxis>(i % n_local_axes)));
    return turns;
}

} // namespace

Compatibility::Compatibility(const Assembler& assembler, const ArtificialRestraints& restraints)
{
    const std::size_t n_unknowns = assembler.equations().n_unknowns();
    const RotationUnit unit(assembler.structure().size());
    const RowList strains = strains_of(assembler, restraints, unit);
    strains_ = strains.matrix(n_unknowns);
    largest_strain_ = strains.largest_entry();
    magnitudes_ = strains_.cwiseAbs();
    turns_ = turns_of(assembler, unit).matrix(n_unknowns);
}

NullModes Compatibility::free_motions(Eigen::Index most) const
{
    const NullSearch search{.zero_tolerance = no_energy, .most = most, .largest_entry = largest_strain_};
    return null_modes(strains_, search, [this](const Eigen::VectorXd& x) { return is_free(x); });
}

bool Compatibility::is_free(const Eigen::VectorXd& x) const
{
    const Eigen::ArrayXd strain = (strains_ * x).cwiseAbs();
    const Eigen::ArrayXd terms = magnitudes_ * x.cwiseAbs();
    const double turn = (turns_ * x).cwiseAbs().maxCoeff();
    return (strain <= strainless * turn + strain_rounding * terms).all();
}

} // namespace femoop
