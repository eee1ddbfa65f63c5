#include "femoop/element/member_element.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <utility>

namespace femoop {

ActionSet elastic_actions(const MemberEndConditions& end_conditions)
{
    if (end_conditions.constraint == Constraint::Rigid)
        return end_conditions.is_bar ? ActionSet{} : ActionSet{Action::RigidOnFoundation};
    if (end_conditions.is_bar)
        return end_conditions.constraint == Constraint::None ? ActionSet{Action::Axial} : ActionSet{};
    if (end_conditions.constraint == Constraint::Inextensible)
        return {Action::Torsion, Action::BendingXY, Action::BendingXZ};
    return all_actions;
}

ActionSet constrained_actions(const MemberEndConditions& end_conditions)
{
    if (end_conditions.constraint == Constraint::None) return {};
    if (end_conditions.constraint == Constraint::Inextensible || end_conditions.is_bar) return {Action::Axial};
    return all_actions;
}

namespace {

/// Where a local axis stands among a model's local displacements; -1 where the model lacks it.
template <AnalysisKind kind> constexpr int row_of(LocalAxis axis)
{
    const auto& local = AnalysisModel<kind>::local;
    for (std::size_t i = 0; i < local.size(); ++i)
        if (local[i] == axis) return static_cast<int>(i);
    return -1;
}

/// A model's rows for bending in one plane: deflection and slope at the first end, then at the second.
template <AnalysisKind kind> constexpr std::array<int, 4> bending_rows(BendingPlane plane)
{
    const int v = row_of<kind>(force_axis(plane));
    const int phi = row_of<kind>(moment_axis(plane));
    const int m = MemberElement<kind>::m;
    return {v, phi, m + v, m + phi};
}

template <AnalysisKind kind> constexpr bool bends(BendingPlane plane)
{
    return row_of<kind>(force_axis(plane)) >= 0 && row_of<kind>(moment_axis(plane)) >= 0;
}

/// Signs that turn a plane's (v, phi, v, phi) into displacements along the member's axes.
std::array<double, 4> bending_signs(BendingPlane plane) { return {1.0, moment_sign(plane), 1.0, moment_sign(plane)}; }

template <AnalysisKind kind, class Matrix> void add_bar(Matrix& K, LocalAxis axis, const Eigen::Matrix2d& k)
{
    const int a = row_of<kind>(axis);
    const int b = MemberElement<kind>::m + a;
    K(a, a) += k(0, 0);
    K(a, b) += k(0, 1);
    K(b, a) += k(1, 0);
    K(b, b) += k(1, 1);
}

template <AnalysisKind kind, class Matrix> void add_beam(Matrix& K, BendingPlane plane, const Eigen::Matrix4d& k)
{
    constexpr auto xy = bending_rows<kind>(BendingPlane::xy);
    constexpr auto xz = bending_rows<kind>(BendingPlane::xz);
    const auto& rows = plane == BendingPlane::xy ? xy : xz;
    const auto signs = bending_signs(plane);
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            K(rows[i], rows[j]) += signs[i] * signs[j] * k(static_cast<int>(i), static_cast<int>(j));
}

/// A displacement of a member's end along one of its axes from the degrees of freedom of its node; the rigid arm
/// from node to end turns with the node.
template <AnalysisKind kind>
Eigen::Matrix<double, 1, MemberElement<kind>::n> transformation_row(LocalAxis axis, const MemberGeometry& geometry,
                                                                    const Eigen::Vector3d* arm)
{
    Eigen::Matrix<double, 1, MemberElement<kind>::n> row;
    const auto a = static_cast<int>(index(axis));
    for (int j = 0; j < MemberElement<kind>::n; ++j) {
        const auto g = static_cast<int>(index(AnalysisModel<kind>::global[static_cast<std::size_t>(j)]));
        const bool same_kind = (a < 3) == (g < 3); // displacement from displacement, rotation from rotation
        row[j] = same_kind ? geometry.axes(a % 3, g % 3) : 0.0;
        if (arm != nullptr && a < 3 && g >= 3)
            row[j] = geometry.axes.row(a).dot(Eigen::Vector3d::Unit(g - 3).cross(*arm));
    }
    return row;
}

const Eigen::Vector3d* offset(const MemberEndConditions* end_conditions, std::size_t end)
{
    return end_conditions != nullptr && end_conditions->has_offset ? &end_conditions->offsets[end] : nullptr;
}

Eigen::Matrix4d beam_stiffness(const Beam& beam, double L, BendingPlane plane)
{
    if (beam.foundation <= 0.0) return beam.stiffness(L);
    SpanLoading pieces;
    pieces.assign(L, {}, beam.longest_piece(), beam.settling());
    return FoundationBeam(beam, pieces, plane, 0.0).stiffness();
}

/// A straight line on a foundation: integral of k N N^T over the length, N = (1 - x/L, 0, x/L, 0).
Eigen::Matrix4d rigid_on_foundation(double k, double L)
{
    Eigen::Matrix4d K = Eigen::Matrix4d::Zero();
    K(0, 0) = K(2, 2) = k * L / 3.0;
    K(0, 2) = K(2, 0) = k * L / 6.0;
    return K;
}

Eigen::Vector4d beam_forces(const Beam& beam, const SpanLoading& loading, BendingPlane plane)
{
    if (beam.foundation <= 0.0) return beam.fixed_end_forces(loading, plane);
    const double curvature = plane == BendingPlane::xy ? loading.curvature() : 0.0;
    return FoundationBeam(beam, loading, plane, curvature).fixed_end_forces();
}

} // namespace

template <AnalysisKind kind>
MemberElement<kind>::MemberElement(const MemberProperties& properties, const MemberGeometry& geometry,
                                   const MemberEndConditions* end_conditions, ActionSet actions)
    : properties_(properties), end_conditions_(end_conditions), geometry_(geometry), actions_(actions)
{}

template <AnalysisKind kind> auto MemberElement<kind>::transformation(std::size_t end) const -> Transformation
{
    Transformation T;
    for (int i = 0; i < m; ++i) T.row(i) = transformation_row(end, AnalysisModel<kind>::local[i]);
    return T;
}

template <AnalysisKind kind>
auto MemberElement<kind>::transformation_row(std::size_t end, LocalAxis axis) const -> Eigen::Matrix<double, 1, n>
{
    return femoop::transformation_row<kind>(axis, geometry_, offset(end_conditions_, end));
}

template <AnalysisKind kind> Beam MemberElement<kind>::own_beam(BendingPlane plane) const
{
    Beam beam = plane == BendingPlane::xy ? properties_.xy : properties_.xz;
    if (end_conditions_ != nullptr && end_conditions_->constraint == Constraint::Rigid) beam.foundation = 0.0;
    return beam;
}

template <AnalysisKind kind> auto MemberElement<kind>::rigid_joint_stiffness() const -> LocalMatrix
{
    LocalMatrix K = LocalMatrix::Zero();
    if constexpr (row_of<kind>(LocalAxis::x) >= 0)
        if (actions_.contains(Action::Axial))
            add_bar<kind>(K, LocalAxis::x, properties_.axial.stiffness(geometry_.length));
    if constexpr (row_of<kind>(LocalAxis::rx) >= 0)
        if (actions_.contains(Action::Torsion))
            add_bar<kind>(K, LocalAxis::rx, properties_.torsion.stiffness(geometry_.length));
    if constexpr (bends<kind>(BendingPlane::xy))
        if (actions_.contains(Action::BendingXY))
            add_beam<kind>(K, BendingPlane::xy,
                           beam_stiffness(own_beam(BendingPlane::xy), geometry_.length, BendingPlane::xy));
    if constexpr (bends<kind>(BendingPlane::xy))
        if (actions_.contains(Action::RigidOnFoundation) && properties_.xy.foundation > 0.0)
            add_beam<kind>(K, BendingPlane::xy, rigid_on_foundation(properties_.xy.foundation, geometry_.length));
    if constexpr (bends<kind>(BendingPlane::xz))
        if (actions_.contains(Action::BendingXZ))
            add_beam<kind>(K, BendingPlane::xz,
                           beam_stiffness(own_beam(BendingPlane::xz), geometry_.length, BendingPlane::xz));
    return K;
}

template <AnalysisKind kind>
auto MemberElement<kind>::rigid_joint_forces(const SpanLoading& loading) const -> LocalVector
{
    LocalVector F = LocalVector::Zero();
    if (loading.is_zero()) return F;
    const auto add_bar_forces = [&](const Bar& bar, LocalAxis axis, int row) {
        const Eigen::Vector2d f = bar.fixed_end_forces(loading, axis);
        F[row] += f[0];
        F[m + row] += f[1];
    };
    const auto add_beam_forces = [&](const Beam& beam, BendingPlane plane, const std::array<int, 4>& rows) {
        const Eigen::Vector4d f = beam_forces(beam, loading, plane);
        const auto signs = bending_signs(plane);
        for (std::size_t i = 0; i < 4; ++i) F[rows[i]] += signs[i] * f[static_cast<int>(i)];
    };
    if constexpr (row_of<kind>(LocalAxis::x) >= 0)
        if (actions_.contains(Action::Axial))
            add_bar_forces(properties_.axial, LocalAxis::x, row_of<kind>(LocalAxis::x));
    if constexpr (row_of<kind>(LocalAxis::rx) >= 0)
        if (actions_.contains(Action::Torsion))
            add_bar_forces(properties_.torsion, LocalAxis::rx, row_of<kind>(LocalAxis::rx));
    if constexpr (bends<kind>(BendingPlane::xy))
        if (actions_.contains(Action::BendingXY))
            add_beam_forces(own_beam(BendingPlane::xy), BendingPlane::xy, bending_rows<kind>(BendingPlane::xy));
    if constexpr (bends<kind>(BendingPlane::xy))
        if (actions_.contains(Action::RigidOnFoundation)) {
            // An imposed curvature presses the foundation: integral of k N (curvature (x^2 - L x) / 2) over the length.
            const double L = geometry_.length;
            const double f = -properties_.xy.foundation * loading.curvature() * L * L * L / 24.0;
            F[row_of<kind>(LocalAxis::y)] += f;
            F[m + row_of<kind>(LocalAxis::y)] += f;
        }
    if constexpr (bends<kind>(BendingPlane::xz))
        if (actions_.contains(Action::BendingXZ))
            add_beam_forces(own_beam(BendingPlane::xz), BendingPlane::xz, bending_rows<kind>(BendingPlane::xz));
    return F;
}

template <AnalysisKind kind> auto MemberElement<kind>::joint_stiffness() const -> LocalVector
{
    LocalVector joints;
    for (std::size_t end = 0; end < 2; ++end)
        for (int i = 0; i < m; ++i)
            joints[static_cast<int>(end) * m + i] =
                end_conditions_->joints[end][index(AnalysisModel<kind>::local[static_cast<std::size_t>(i)])];
    return joints;
}

template <AnalysisKind kind> auto MemberElement<kind>::action_forms() const -> std::vector<ActionForm>
{
    std::vector<ActionForm> actions;
    const double L = geometry_.length;
    const auto add_bar = [&](LocalAxis axis, const Bar& bar) {
        const double unit = is_rotation(axis) ? 1.0 : L;
        if (const int row = row_of<kind>(axis); row >= 0)
            actions.push_back({{row, m + row}, strain_form(bar, L), unit});
    };
    const auto add_beam = [&](BendingPlane plane) {
        if (!bends<kind>(plane)) return;
        const auto rows = bending_rows<kind>(plane);
        const auto signs = bending_signs(plane);
        StrainForm form = strain_form(own_beam(plane), L, plane);
        form.B *= Eigen::Map<const Eigen::Vector4d>(signs.data()).asDiagonal();
        actions.push_back({{rows.begin(), rows.end()}, std::move(form), 1.0});
    };
    if (actions_.contains(Action::Axial)) add_bar(LocalAxis::x, properties_.axial);
    if (actions_.contains(Action::Torsion)) add_bar(LocalAxis::rx, properties_.torsion);
    if (actions_.contains(Action::BendingXY)) add_beam(BendingPlane::xy);
    if (actions_.contains(Action::BendingXZ)) add_beam(BendingPlane::xz);
    if (actions_.contains(Action::RigidOnFoundation) && bends<kind>(BendingPlane::xy) &&
        properties_.xy.foundation > 0.0)
        actions.push_back(
            {{row_of<kind>(LocalAxis::y), m + row_of<kind>(LocalAxis::y)},
             {.B = Eigen::Matrix2d::Identity(), .S = rigid_on_foundation(properties_.xy.foundation, L)({0, 2}, {0, 2})},
             L});
    return actions;
}

template <AnalysisKind kind> auto MemberElement<kind>::jointed_actions() const -> std::vector<JointedAction>
{
    std::vector<JointedAction> actions;
    const LocalVector joints = joint_stiffness();
    for (ActionForm& action : action_forms()) {
        const JointCondensation condensation(action.form, joints(action.rows));
        actions.push_back({.rows = std::move(action.rows), .condensation = condensation});
    }
    return actions;
}

template <AnalysisKind kind>
template <class FormOf>
StrainForm MemberElement<kind>::gathered_strains(FormOf&& form_of) const
{
    StrainForm all{.B = Eigen::MatrixXd(0, 2 * m), .S = Eigen::MatrixXd(0, 0)};
    for (const ActionForm& action : action_forms()) {
        const StrainForm form = form_of(action);
        const Eigen::Index size = all.S.rows() + form.S.rows();
        all.B.conservativeResizeLike(Eigen::MatrixXd::Zero(size, 2 * m));
        all.S.conservativeResizeLike(Eigen::MatrixXd::Zero(size, size));
        all.B.bottomRows(form.B.rows())(Eigen::all, action.rows) = form.B / action.unit;
        all.S.bottomRightCorner(form.S.rows(), form.S.rows()) = form.S * (action.unit * action.unit);
    }
    return all;
}

template <AnalysisKind kind> StrainForm MemberElement<kind>::rigid_joint_strains() const
{
    return gathered_strains([](const ActionForm& action) { return action.form; });
}

template <AnalysisKind kind> StrainForm MemberElement<kind>::strains() const
{
    if (!has_flexible_joint()) return rigid_joint_strains();
    const LocalVector joints = joint_stiffness();
    return gathered_strains(
        [&](const ActionForm& action) { return JointCondensation(action.form, joints(action.rows)).strain_form(); });
}

template <AnalysisKind kind> auto MemberElement<kind>::local_stiffness() const -> LocalMatrix
{
    if (!has_flexible_joint()) return rigid_joint_stiffness();
    LocalMatrix K = LocalMatrix::Zero();
    for (const JointedAction& action : jointed_actions()) K(action.rows, action.rows) = action.condensation.stiffness();
    return K;
}

template <AnalysisKind kind>
auto MemberElement<kind>::local_fixed_end_forces(const SpanLoading& loading) const -> LocalVector
{
    const LocalVector f = rigid_joint_forces(loading);
    return has_flexible_joint() ? end_forces(LocalVector::Zero(), f) : f;
}

template <AnalysisKind kind> auto MemberElement<kind>::stiffness() const -> GlobalMatrix
{
    const LocalMatrix k = local_stiffness();
    const std::array<Transformation, 2> T{transformation(0), transformation(1)};
    GlobalMatrix K;
    for (int i = 0; i < 2; ++i)
        for (int j = i; j < 2; ++j) {
            const Eigen::Matrix<double, n, n> block = T[i].transpose() * k.template block<m, m>(i * m, j * m) * T[j];
            K.template block<n, n>(i * n, j * n) = block;
            if (i != j) K.template block<n, n>(j * n, i * n) = block.transpose();
        }
    return K;
}

template <AnalysisKind kind> auto MemberElement<kind>::to_nodes(const LocalVector& local) const -> GlobalVector
{
    GlobalVector F;
    F.template head<n>() = transformation(0).transpose() * local.template head<m>();
    F.template tail<n>() = transformation(1).transpose() * local.template tail<m>();
    return F;
}

template <AnalysisKind kind>
auto MemberElement<kind>::fixed_end_forces(const SpanLoading& loading) const -> GlobalVector
{
    GlobalVector F = to_nodes(local_fixed_end_forces(loading));
    if (is_truss(kind) || (end_conditions_ != nullptr && end_conditions_->is_bar)) F += simple_span_forces(loading);
    return F;
}

template <AnalysisKind kind>
auto MemberElement<kind>::end_displacements(const LocalVector& nodes, const LocalVector& rigid_joint_forces) const
    -> LocalVector
{
    LocalVector d = nodes;
    for (const JointedAction& action : jointed_actions())
        d(action.rows) = action.condensation.end_displacements(nodes(action.rows), rigid_joint_forces(action.rows));
    return d;
}

template <AnalysisKind kind>
auto MemberElement<kind>::end_forces(const LocalVector& nodes, const LocalVector& rigid_joint_forces) const
    -> LocalVector
{
    LocalVector p = rigid_joint_forces;
    for (const JointedAction& action : jointed_actions())
        p(action.rows) = action.condensation.end_forces(nodes(action.rows), rigid_joint_forces(action.rows));
    return p;
}

template <AnalysisKind kind>
std::vector<InternalMechanism> MemberElement<kind>::internal_mechanisms(const LocalVector& rigid_joint_forces) const
{
    std::vector<InternalMechanism> found;
    if (!has_flexible_joint()) return found;
    const auto axis_of = [](int row) { return AnalysisModel<kind>::local[static_cast<std::size_t>(row % m)]; };
    for (const JointedAction& action : jointed_actions())
        for (const JointCondensation::FreeMotion& free_motion : action.condensation.free_motions()) {
            const int free = action.rows[static_cast<std::size_t>(free_motion.row)];
            InternalMechanism end{.end = static_cast<std::size_t>(free / m), .axis = axis_of(free), .mode = {}};
            for (auto& vector : end.mode) vector.setZero();
            for (std::size_t i = 0; i < action.rows.size(); ++i) {
                const int row = action.rows[i];
                end.mode[static_cast<std::size_t>(row / m)][static_cast<int>(index(axis_of(row)))] =
                    free_motion.mode[static_cast<Eigen::Index>(i)];
            }
            end.work = JointCondensation::work(free_motion, rigid_joint_forces(action.rows));
            found.push_back(end);
        }
    return found;
}

template <AnalysisKind kind>
auto MemberElement<kind>::simple_span_forces(const SpanLoading& loading) const -> GlobalVector
{
    GlobalVector F = GlobalVector::Zero();
    for (const BendingPlane plane : {BendingPlane::xy, BendingPlane::xz}) {
        const Eigen::Vector2d reactions = Beam::simple_span_forces(loading, plane);
        for (std::size_t end = 0; end < 2; ++end) {
            const auto row = transformation_row(end, force_axis(plane));
            F.template segment<n>(static_cast<int>(end) * n) += reactions[static_cast<int>(end)] * row.transpose();
        }
    }
    return F;
}

template class MemberElement<AnalysisKind::Truss2d>;
template class MemberElement<AnalysisKind::Frame2d>;
template class MemberElement<AnalysisKind::Grillage>;
template class MemberElement<AnalysisKind::Truss3d>;
template class MemberElement<AnalysisKind::Frame3d>;

} // namespace femoop
