#include "femoop/analysis/assembler.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>

#include "femoop/element/analysis_model.h"

namespace femoop {

namespace {

/// f += forces, at the equations that there are.
template <class Scalar, class Forces>
void add(std::span<const std::int32_t> rows, const Forces& forces, Eigen::Matrix<Scalar, Eigen::Dynamic, 1>& f)
{
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i] != Equations::none) f[rows[i]] += forces[static_cast<Eigen::Index>(i)];
}

} // namespace

Assembler::Assembler(const Discretisation& structure, const Elements& elements, const Equations& equations)
    : structure_(structure), elements_(elements), equations_(equations), axes_(structure)
{}

/// Calls add(equation, spring stiffness) for every support spring of an unknown.
template <class Add> void Assembler::visit_springs(Add&& add) const
{
    const std::span<const Dof> dofs = model_dofs(structure_.kind);
    for (const Discretisation::SupportRow& support : structure_.supports)
        for (std::size_t i = 0; i < dofs.size(); ++i)
            if (const std::int32_t row = equations_.of(support.node, i); row != Equations::none)
                add(row, support.springs[index(dofs[i])], support.node.index * dofs.size() + i);
}

/// Adds what matrix(element, M) makes of each element, once of those that share it.
template <class Matrix> void Assembler::add_elements(SparseMatrix& A, Matrix&& matrix) const
{
    const SystemPattern& pattern = equations_.pattern();
    ElementMatrix repeated, turned;
    std::uint32_t group = 0; // of `repeated`
    for (std::size_t i = 0; i < elements_.size(); ++i) {
        const Element& element = elements_[i];
        if (group == 0 || element.stiffness_group() != group) matrix(element, repeated);
        group = element.stiffness_group();
        if (!axes_.are_turned() || !axes_.are_turned(element.dofs())) {
            pattern.add(A, i, equations_.of_element(i), repeated);
            continue;
        }
        turned = repeated;
        axes_.turn(element.dofs(), turned);
        pattern.add(A, i, equations_.of_element(i), turned);
    }
}

double Assembler::add_stiffness(SparseMatrix& K) const
{
    double largest = 0.0;
    add_elements(K, [&](const Element& element, ElementMatrix& own) {
        element.stiffness(own);
        if (own.size() > 0) largest = std::max(largest, own.diagonal().maxCoeff());
    });
    visit_springs(
        [&](std::int32_t row, double spring, std::size_t) { equations_.pattern().add_to_diagonal(K, row, spring); });
    return largest;
}

void Assembler::add_mass(SparseMatrix& M) const
{
    add_elements(M, [](const Element& element, ElementMatrix& own) { element.mass(own); });
}

void Assembler::add_stiffness(PreciseSparseMatrix& K) const
{
    const SystemPattern& pattern = equations_.pattern();
    for (std::size_t i = 0; i < elements_.size(); ++i)
        pattern.add(K, i, equations_.of_element(i), stiffness<DoubleDouble>(i));
    visit_springs([&](std::int32_t row, double spring, std::size_t) { pattern.add_to_diagonal(K, row, spring); });
}

/// Of one element, in the axes of its nodes.
template <class Scalar> auto Assembler::stiffness(std::size_t element) const -> Dense<Scalar>
{
    Dense<Scalar> K;
    if constexpr (std::is_same_v<Scalar, DoubleDouble>) K = elements_[element].precise_stiffness();
    else {
        ElementMatrix own;
        elements_[element].stiffness(own);
        K = own;
    }
    axes_.turn(elements_[element].dofs(), K);
    return K;
}

template <class Scalar> auto Assembler::constrained_stiffness() const -> Sparse<Scalar>
{
    Sparse<Scalar> K = equations_.pattern().matrix().template cast<Scalar>();
    for (std::size_t i = 0; i < structure_.members.size(); ++i) {
        const StraightMember& member = elements_[MemberId(i)];
        if (!member.is_constrained()) continue;
        Dense<Scalar> own;
        if constexpr (std::is_same_v<Scalar, DoubleDouble>) own = member.precise_constrained_stiffness();
        else own = member.constrained_stiffness();
        axes_.turn(member.dofs(), own);
        equations_.pattern().add(K, i, equations_.of_element(i), own);
    }
    return K;
}

SparseMatrix Assembler::resistance() const
{
    SparseMatrix found = equations_.pattern().matrix();
    for (std::size_t i = 0; i < structure_.members.size(); ++i) {
        const StraightMember& member = elements_[MemberId(i)];
        Eigen::MatrixXd own = member.resistance();
        axes_.turn(member.dofs(), own);
        equations_.pattern().add(found, i, equations_.of_element(i).first(static_cast<std::size_t>(own.rows())), own);
    }
    visit_springs([&](std::int32_t row, double spring, std::size_t) {
        if (spring > 0.0) equations_.pattern().add_to_diagonal(found, row, 1.0);
    });
    return found;
}

Eigen::MatrixXd Assembler::in_node_axes(std::size_t element, Eigen::MatrixXd M) const
{
    axes_.turn_columns(elements_[element].dofs(), M);
    return M;
}

std::vector<double> Assembler::settlements(const CaseLoads& loads) const
{
    if (loads.settlements.empty()) return {};
    const std::span<const Dof> dofs = model_dofs(structure_.kind);
    std::vector<double> moved(structure_.positions.size() * dofs.size(), 0.0);
    for (const CaseLoads::OnNode& settlement : loads.settlements)
        for (std::size_t i = 0; i < dofs.size(); ++i)
            moved[settlement.node.index * dofs.size() + i] += settlement.value[index(dofs[i])];
    return moved;
}

template <class Scalar> auto Assembler::load_vector(const CaseLoads& loads) const -> Vector<Scalar>
{
    Vector<Scalar> f = Vector<Scalar>::Zero(static_cast<Eigen::Index>(equations_.n_unknowns()));
    add_node_loads(loads, f);
    if (!loads.first.empty()) add_span_loads(loads, f);
    for (const CaseLoads::OnElement& on : loads.elements) add_element_loads(on.element, on.loads(), f);
    if (!loads.settlements.empty()) add_settlements(loads, f);
    return f;
}

template <class Scalar> void Assembler::add_node_loads(const CaseLoads& loads, Vector<Scalar>& f) const
{
    const std::span<const Dof> dofs = model_dofs(structure_.kind);
    Vector<Scalar> value(static_cast<Eigen::Index>(dofs.size()));
    for (const CaseLoads::OnNode& load : loads.nodes) {
        for (std::size_t i = 0; i < dofs.size(); ++i) value[static_cast<Eigen::Index>(i)] = load.value[index(dofs[i])];
        axes_.turn_rows({.nodes = std::span(&load.node, 1), .of_each_node = dofs}, value);
        for (std::size_t i = 0; i < dofs.size(); ++i)
            if (const std::int32_t row = equations_.of(load.node, i); row != Equations::none)
                f[row] += value[static_cast<Eigen::Index>(i)];
    }
}

template <class Scalar> void Assembler::add_span_loads(const CaseLoads& loads, Vector<Scalar>& f) const
{
    SpanLoading room;
    ElementVector forces;
    std::span<const SpanLoad> last; // that `forces` come from, on a member of this group
    std::uint32_t group = 0;
    for (std::size_t i = 0; i < structure_.members.size(); ++i) {
        const std::span<const SpanLoad> on_member = loads.of(MemberId(i));
        if (on_member.empty()) continue;
        const Element& element = elements_[i];
        if (group == 0 || element.stiffness_group() != group || !std::ranges::equal(on_member, last))
            element.equivalent_forces({.span_loads = on_member, .room = &room}, forces);
        group = element.stiffness_group();
        last = on_member;
        add_element_forces(i, forces, f);
    }
}

template <class Scalar>
void Assembler::add_element_loads(std::size_t element, const ElementLoads& loads, Vector<Scalar>& f) const
{
    ElementVector forces;
    elements_[element].equivalent_forces(loads, forces);
    add_element_forces(element, forces, f);
}

template <class Scalar>
void Assembler::add_element_forces(std::size_t element, const ElementVector& forces, Vector<Scalar>& f) const
{
    const std::span<const std::int32_t> rows = equations_.of_element(element);
    const ElementDofs dofs = elements_[element].dofs();
    if (!axes_.are_turned() || !axes_.are_turned(dofs)) {
        add(rows, forces, f);
        return;
    }
    ElementVector turned = forces;
    axes_.turn_rows(dofs, turned);
    add(rows, turned, f);
}

ElementVector Assembler::prescribed(std::size_t element, const std::vector<double>& moved) const
{
    const ElementDofs touched = elements_[element].dofs();
    const std::span<const Dof> dofs = model_dofs(structure_.kind);
    const std::span<const std::int32_t> rows = equations_.of_element(element);
    ElementVector u = ElementVector::Zero(static_cast<Eigen::Index>(rows.size()));
    if (moved.empty()) return u;
    for (std::size_t k = 0; k < touched.n_of_nodes(); ++k) {
        if (rows[k] != Equations::none) continue;
        const NodeId node = touched.nodes[k / touched.of_each_node.size()];
        const auto place = std::ranges::find(dofs, touched.of_each_node[k % touched.of_each_node.size()]);
        u[static_cast<Eigen::Index>(k)] =
            moved[node.index * dofs.size() + static_cast<std::size_t>(place - dofs.begin())];
    }
    return u;
}

template <class Scalar> void Assembler::add_settlements(const CaseLoads& loads, Vector<Scalar>& f) const
{
    const std::vector<double> moved = settlements(loads);
    for (std::size_t i = 0; i < elements_.size(); ++i) {
        const ElementVector u = prescribed(i, moved);
        if (u.isZero(0.0)) continue;
        const Vector<Scalar> forces = -(stiffness<Scalar>(i) * u.template cast<Scalar>());
        add(equations_.of_element(i), forces, f);
    }
    visit_springs(
        [&](std::int32_t row, double spring, std::size_t place) { f[row] += Scalar(spring) * Scalar(moved[place]); });
}

template SparseMatrix Assembler::constrained_stiffness<double>() const;
template PreciseSparseMatrix Assembler::constrained_stiffness<DoubleDouble>() const;
template Eigen::VectorXd Assembler::load_vector<double>(const CaseLoads& loads) const;
template PreciseVector Assembler::load_vector<DoubleDouble>(const CaseLoads& loads) const;

} // namespace femoop
