#include "femoop/analysis/assembly.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace femoop {

template <AnalysisKind kind, class Scalar>
Assembly<kind, Scalar>::Assembly(const Discretisation& structure, const Equations& equations)
    : structure_(structure), equations_(equations)
{
    const auto is_inclined = [](const Discretisation::SupportRow& support) { return support.angle != 0.0; };
    if (std::none_of(structure.supports.begin(), structure.supports.end(), is_inclined)) return;
    for (const Discretisation::SupportRow& support : structure.supports) {
        NodeMatrix axes = NodeMatrix::Identity();
        const double c = std::cos(support.angle);
        const double s = std::sin(support.angle);
        axes.template topLeftCorner<2, 2>() << c, -s, s, c;
        support_axes_.push_back(axes);
    }
}

template <AnalysisKind kind, class Scalar> auto Assembly<kind, Scalar>::axes_of(NodeId node) const -> const NodeMatrix*
{
    if (support_axes_.empty() || structure_.support_of_node[node.index] < 0) return nullptr;
    const auto support = static_cast<std::size_t>(structure_.support_of_node[node.index]);
    return structure_.supports[support].angle != 0.0 ? &support_axes_[support] : nullptr;
}

template <AnalysisKind kind, class Scalar> bool Assembly<kind, Scalar>::is_constrained(MemberId member) const
{
    const MemberEndConditions* end_conditions = structure_.end_conditions_of(member);
    return end_conditions != nullptr && end_conditions->constraint != Constraint::None;
}

template <AnalysisKind kind, class Scalar>
auto Assembly<kind, Scalar>::element(MemberId member, const MemberGeometry& geometry) const -> Element
{
    const MemberEndConditions* end_conditions = structure_.end_conditions_of(member);
    return element_of(member, geometry, end_conditions == nullptr ? all_actions : elastic_actions(*end_conditions),
                      structure_.properties_of(member));
}

template <AnalysisKind kind, class Scalar>
auto Assembly<kind, Scalar>::constrained_element(MemberId member, const MemberGeometry& geometry) const -> Element
{
    return element_of(member, geometry, constrained_actions(*structure_.end_conditions_of(member)),
                      structure_.properties_of(member));
}

template <AnalysisKind kind, class Scalar>
auto Assembly<kind, Scalar>::unit_element(MemberId member, const MemberGeometry& geometry, ActionSet actions) const
    -> Element
{
    static constexpr MemberProperties unit{.axial = {1.0}, .torsion = {1.0}, .xy = {.EI = 1.0}, .xz = {.EI = 1.0}};
    return element_of(member, geometry, actions, unit);
}

template <AnalysisKind kind, class Scalar>
auto Assembly<kind, Scalar>::resisting_elements(MemberId member, const MemberGeometry& geometry) const
    -> std::vector<Element>
{
    std::vector<Element> elements{element(member, geometry)};
    if (is_constrained(member))
        elements.push_back(unit_element(member, geometry, constrained_actions(*structure_.end_conditions_of(member))));
    return elements;
}

template <AnalysisKind kind, class Scalar>
auto Assembly<kind, Scalar>::element_of(MemberId member, const MemberGeometry& geometry, ActionSet actions,
                                        const MemberProperties& properties) const -> Element
{
    const auto& nodes = structure_.members[member.index].nodes;
    return Element(properties, geometry, structure_.end_conditions_of(member), {axes_of(nodes[0]), axes_of(nodes[1])},
                   actions);
}

template <AnalysisKind kind, class Scalar>
auto Assembly<kind, Scalar>::node_equations(MemberId member) const -> std::array<std::int32_t, 2 * n>
{
    std::array<std::int32_t, 2 * n> rows;
    const auto& nodes = structure_.members[member.index].nodes;
    for (std::size_t end = 0; end < 2; ++end)
        for (std::size_t i = 0; i < n; ++i) rows[end * n + i] = equations_.of(nodes[end], i);
    return rows;
}

template <AnalysisKind kind, class Scalar>
auto Assembly<kind, Scalar>::member_ends(MemberId member, const Element& element) const -> MemberEndDofs
{
    constexpr int m = Element::m;
    const auto nodes = node_equations(member);
    MemberEndDofs own{.equations = {nodes.begin(), nodes.end()},
                      .B = Dense::Zero(2 * m, 2 * n),
                      .gaps = Dense(0, 2 * n),
                      .joints = {}};
    const MemberEndConditions& end_conditions = *structure_.end_conditions_of(member);
    for (int end = 0; end < 2; ++end) {
        const auto T = element.template transformation<Scalar>(end);
        for (int i = 0; i < m; ++i) {
            const LocalAxis axis = AnalysisModel<kind>::local[i];
            const double joint = end_conditions.joints[end][index(axis)];
            Dense follows = Dense::Zero(1, own.B.cols());
            for (int j = 0; j < n; ++j) follows(0, end * n + j) = T(i, j);
            if (!std::isfinite(joint)) {
                own.B.row(end * m + i) = follows;
                continue;
            }
            const Eigen::Index size = own.B.cols() + 1;
            own.equations.push_back(equations_.of_member_end(member, end, axis));
            own.B.conservativeResizeLike(Dense::Zero(2 * m, size));
            own.B(end * m + i, size - 1) = 1.0;
            own.gaps.conservativeResizeLike(Dense::Zero(own.gaps.rows() + 1, size));
            own.gaps.bottomRows(1) << -follows, Dense::Ones(1, 1);
            own.joints.conservativeResizeLike(Eigen::VectorXd::Constant(own.gaps.rows(), joint));
        }
    }
    return own;
}

namespace {

Eigen::MatrixXd between_rigid_joints(const auto& element, const Eigen::MatrixXd& B)
{
    return B.transpose() * element.rigid_joint_stiffness() * B;
}

PreciseMatrix stiffness_of(const StrainForm& form, const PreciseMatrix& B)
{
    const PreciseMatrix strains = form.B.cast<DoubleDouble>() * B;
    return strains.transpose() * (form.S.cast<DoubleDouble>() * strains);
}

PreciseMatrix between_rigid_joints(const auto& element, const PreciseMatrix& B)
{
    return stiffness_of(element.rigid_joint_strains(), B);
}

/// What a member's nodes feel.
template <class Scalar> auto node_stiffness(const auto& element)
{
    if constexpr (std::is_same_v<Scalar, double>) return element.stiffness();
    else {
        const PreciseMatrix first = element.template transformation<Scalar>(0);
        const PreciseMatrix second = element.template transformation<Scalar>(1);
        PreciseMatrix T = PreciseMatrix::Zero(first.rows() + second.rows(), first.cols() + second.cols());
        T.topLeftCorner(first.rows(), first.cols()) = first;
        T.bottomRightCorner(second.rows(), second.cols()) = second;
        return stiffness_of(element.strains(), T);
    }
}

} // namespace

template <AnalysisKind kind, class Scalar>
template <class Visit>
void Assembly<kind, Scalar>::visit_member(MemberId member, Visit&& visit) const
{
    const MemberGeometry geometry = structure_.geometry(member);
    const Element elastic = element(member, geometry);
    if (!is_constrained(member)) {
        const auto rows = node_equations(member);
        visit(std::span<const std::int32_t>(rows), node_stiffness<Scalar>(elastic));
        return;
    }
    const MemberEndDofs own = member_ends(member, elastic);
    const Dense springs = own.joints.template cast<Scalar>().asDiagonal() * own.gaps;
    const Dense K = between_rigid_joints(elastic, own.B) + own.gaps.transpose() * springs;
    visit(std::span<const std::int32_t>(own.equations), K);
}

template <AnalysisKind kind, class Scalar> bool Assembly<kind, Scalar>::is_plain(MemberId member) const
{
    const auto& row = structure_.members[member.index];
    return row.end_conditions < 0 && axes_of(row.nodes[0]) == nullptr && axes_of(row.nodes[1]) == nullptr;
}

template <AnalysisKind kind, class Scalar> void Assembly<kind, Scalar>::add_stiffness(Sparse& K) const
{
    const SystemPattern& pattern = equations_.pattern();
    // Most structures repeat themselves: a member like the plain one before it has its stiffness.
    struct {
        std::uint32_t properties = 0;
        Eigen::Vector3d span = Eigen::Vector3d::Zero(); // no member's
        typename Element::GlobalMatrix K;
    } last;
    for (std::size_t i = 0; i < structure_.members.size(); ++i) {
        const MemberId member(i);
        if (!std::is_same_v<Scalar, double> || !is_plain(member)) {
            visit_member(member,
                         [&](std::span<const std::int32_t> rows, const auto& Ke) { pattern.add(K, i, rows, Ke); });
            continue;
        }
        const Discretisation::MemberRow& row = structure_.members[i];
        const Eigen::Vector3d span = structure_.positions[row.nodes[1].index] -
                                     structure_.positions[row.nodes[0].index];
        if (span != last.span || row.properties != last.properties)
            last = {row.properties, span, element(member, structure_.geometry(member)).stiffness()};
        pattern.add(K, i, node_equations(member), last.K);
    }
    for (const Discretisation::SupportRow& support : structure_.supports)
        for (std::size_t i = 0; i < n; ++i)
            if (const std::int32_t row = equations_.of(support.node, i); row != Equations::none)
                pattern.add_to_diagonal(K, row, support.springs[index(AnalysisModel<kind>::global[i])]);
}

template <AnalysisKind kind, class Scalar> auto Assembly<kind, Scalar>::constrained_stiffness() const -> Sparse
{
    Sparse K = equations_.pattern().matrix().template cast<Scalar>();
    for (std::size_t i = 0; i < structure_.members.size(); ++i) {
        const MemberId member(i);
        if (!is_constrained(member)) continue;
        const MemberGeometry geometry = structure_.geometry(member);
        const Element constrained = constrained_element(member, geometry);
        const MemberEndDofs own = member_ends(member, constrained);
        equations_.pattern().add(K, i, own.equations, between_rigid_joints(constrained, own.B));
    }
    return K;
}

template <AnalysisKind kind, class Scalar>
std::vector<double> Assembly<kind, Scalar>::settlements(const CaseLoads& loads) const
{
    if (loads.settlements.empty()) return {};
    std::vector<double> moved(structure_.positions.size() * n, 0.0);
    for (const CaseLoads::OnNode& settlement : loads.settlements)
        for (std::size_t i = 0; i < n; ++i)
            moved[settlement.node.index * n + i] += settlement.value[index(AnalysisModel<kind>::global[i])];
    return moved;
}

template <AnalysisKind kind, class Scalar>
auto Assembly<kind, Scalar>::load_vector(const CaseLoads& loads) const -> Vector
{
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(equations_.n_unknowns()));
    add_node_loads(loads, forces);
    if (!loads.first.empty()) add_member_loads(loads, forces);
    Vector f = forces.template cast<Scalar>();
    if (!loads.settlements.empty()) add_settlements(loads, f);
    return f;
}

template <AnalysisKind kind, class Scalar>
void Assembly<kind, Scalar>::add_node_loads(const CaseLoads& loads, Eigen::VectorXd& f) const
{
    for (const CaseLoads::OnNode& load : loads.nodes) {
        Eigen::Matrix<double, n, 1> value;
        for (int i = 0; i < n; ++i)
            value[i] = load.value[index(AnalysisModel<kind>::global[static_cast<std::size_t>(i)])];
        if (const NodeMatrix* axes = axes_of(load.node)) value = (axes->transpose() * value).eval();
        for (int i = 0; i < n; ++i)
            if (const std::int32_t row = equations_.of(load.node, static_cast<std::size_t>(i)); row != Equations::none)
                f[row] += value[i];
    }
}

template <AnalysisKind kind, class Scalar>
void Assembly<kind, Scalar>::add_member_loads(const CaseLoads& loads, Eigen::VectorXd& f) const
{
    SpanLoading loading;
    const auto subtract = [&f](const auto& rows, const auto& forces) {
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (rows[i] != Equations::none) f[rows[i]] -= forces[static_cast<Eigen::Index>(i)];
    };
    for (std::size_t i = 0; i < structure_.members.size(); ++i) {
        const MemberId member(i);
        if (loads.of(member).empty()) continue;
        const MemberGeometry geometry = structure_.geometry(member);
        const std::array<SpanLoading::Scaled, 1> terms{{{.loads = loads.of(member)}}};
        structure_.properties_of(member).xy.cut(loading, geometry.length, terms);
        if (!is_constrained(member)) {
            subtract(node_equations(member), element(member, geometry).fixed_end_forces(loading));
            continue;
        }
        const MemberEndConditions& end_conditions = *structure_.end_conditions_of(member);
        const Element elastic = element(member, geometry);
        const Element constrained = constrained_element(member, geometry);
        const MemberEndDofs own = member_ends(member, elastic);
        const Eigen::VectorXd fixed = elastic.rigid_joint_forces(loading) +
                                      constrained.rigid_joint_forces(loading.without_strain());
        subtract(own.equations, Eigen::VectorXd(own.B.template cast<double>().transpose() * fixed));
        if (end_conditions.is_bar) subtract(node_equations(member), elastic.simple_span_forces(loading));
    }
}

template <AnalysisKind kind, class Scalar>
void Assembly<kind, Scalar>::add_settlements(const CaseLoads& loads, Vector& f) const
{
    const std::vector<double> moved = settlements(loads);
    for (std::size_t i = 0; i < structure_.members.size(); ++i) {
        const auto& nodes = structure_.members[i].nodes;
        Eigen::Matrix<double, 2 * n, 1> u;
        for (int row = 0; row < 2 * n; ++row) {
            const NodeId node = nodes[static_cast<std::size_t>(row / n)];
            const auto dof = static_cast<std::size_t>(row % n);
            u[row] = equations_.of(node, dof) == Equations::none ? moved[node.index * n + dof] : 0.0;
        }
        if (u.isZero(0.0)) continue;
        visit_member(MemberId(i), [&](std::span<const std::int32_t> rows, const auto& K) {
            const Vector forces = K.leftCols(2 * n) * u.template cast<Scalar>();
            for (std::size_t row = 0; row < rows.size(); ++row)
                if (rows[row] != Equations::none) f[rows[row]] -= forces[static_cast<Eigen::Index>(row)];
        });
    }
    for (const Discretisation::SupportRow& support : structure_.supports)
        for (std::size_t i = 0; i < n; ++i)
            if (const std::int32_t row = equations_.of(support.node, i); row != Equations::none)
                f[row] += Scalar(support.springs[index(AnalysisModel<kind>::global[i])]) *
                          Scalar(moved[support.node.index * n + i]);
}

template <AnalysisKind kind, class Scalar>
void Assembly<kind, Scalar>::to_global(std::vector<Scalar>& displacements) const
{
    for (std::size_t s = 0; s < support_axes_.size(); ++s) {
        const NodeId node = structure_.supports[s].node;
        Eigen::Map<Eigen::Matrix<Scalar, n, 1>> u(displacements.data() + node.index * n);
        u = (support_axes_[s].template cast<Scalar>() * u).eval();
    }
}

template class Assembly<AnalysisKind::Truss2d>;
template class Assembly<AnalysisKind::Truss2d, DoubleDouble>;
template class Assembly<AnalysisKind::Frame2d>;
template class Assembly<AnalysisKind::Frame2d, DoubleDouble>;
template class Assembly<AnalysisKind::Grillage>;
template class Assembly<AnalysisKind::Grillage, DoubleDouble>;
template class Assembly<AnalysisKind::Truss3d>;
template class Assembly<AnalysisKind::Truss3d, DoubleDouble>;
template class Assembly<AnalysisKind::Frame3d>;
template class Assembly<AnalysisKind::Frame3d, DoubleDouble>;

} // namespace femoop
