#include "femoop/element/straight_member.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "femoop/algebra/congruence.h"
#include "femoop/element/member_element.h"

namespace femoop {

namespace {

/// Where a local axis stands among a model's local displacements; -1 where the model lacks it.
template <AnalysisKind kind> int local_row(LocalAxis axis)
{
    const auto& local = AnalysisModel<kind>::local;
    const auto at = std::ranges::find(local, axis);
    return at == local.end() ? -1 : static_cast<int>(at - local.begin());
}

Eigen::MatrixXd stacked(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
    Eigen::MatrixXd both(a.rows() + b.rows(), a.cols());
    both << a, b;
    return both;
}

PreciseMatrix precise_stiffness_of(const StrainForm& form, const Eigen::MatrixXd& B)
{
    const PreciseMatrix strains = form.B.cast<DoubleDouble>() * B.cast<DoubleDouble>();
    return strains.transpose() * (form.S.cast<DoubleDouble>() * strains);
}

/// The displacements of a member's ends, local = B u, of a member whose joints are not condensed.
struct EndDisplacements {
    Eigen::MatrixXd B;      ///< [2m x dofs]
    Eigen::MatrixXd gaps;   ///< between node and end at joints that are not rigid [joints x dofs]
    Eigen::VectorXd joints; ///< their stiffnesses; 0 where released

    /// What strains the springs; releases are not strained.
    Eigen::MatrixXd sprung_gaps() const
    {
        std::vector<Eigen::Index> sprung;
        for (Eigen::Index i = 0; i < joints.size(); ++i)
            if (joints[i] > 0.0) sprung.push_back(i);
        return gaps(sprung, Eigen::all);
    }
    Eigen::MatrixXd joint_stiffness() const { return congruence(joints.asDiagonal(), gaps); }
    PreciseMatrix precise_joint_stiffness() const
    {
        const PreciseMatrix precise_gaps = gaps.cast<DoubleDouble>();
        const PreciseMatrix springs = joints.cast<DoubleDouble>().asDiagonal() * precise_gaps;
        return precise_gaps.transpose() * springs;
    }
};

/// The rows of a constraint over a member's local end displacements, one after the other.
class ConstraintRowList {
public:
    explicit ConstraintRowList(int m) : m_(m) {}

    Eigen::RowVectorXd difference(int row) const
    {
        Eigen::RowVectorXd c = Eigen::RowVectorXd::Zero(2 * m_);
        c[row] = -1.0;
        c[m_ + row] = 1.0;
        return c;
    }
    void add(const Eigen::RowVectorXd& c, double strain, double curvature)
    {
        const Eigen::Index r = rows_.C.rows();
        rows_.C.conservativeResize(r + 1, 2 * m_);
        rows_.strain.conservativeResize(r + 1);
        rows_.curvature.conservativeResize(r + 1);
        rows_.C.row(r) = c;
        rows_.strain[r] = strain;
        rows_.curvature[r] = curvature;
    }
    /// \param B  the local end displacements from the member's degrees of freedom
    StraightMember::ConstraintRows over(const Eigen::MatrixXd& B) const
    {
        StraightMember::ConstraintRows rows = rows_;
        rows.C = rows_.C * B;
        return rows;
    }

private:
    int m_;
    StraightMember::ConstraintRows rows_{.C = Eigen::MatrixXd(0, 2 * m_), .strain = {}, .curvature = {}};
};

template <AnalysisKind kind>
StraightMember::ConstraintRows constraint_rows(ActionSet actions, double L, const Eigen::MatrixXd& B)
{
    constexpr int m = MemberElement<kind>::m;
    ConstraintRowList rows(m);
    if (const int x = local_row<kind>(LocalAxis::x); x >= 0 && actions.contains(Action::Axial))
        rows.add(rows.difference(x), L, 0.0);
    if (const int rx = local_row<kind>(LocalAxis::rx); rx >= 0 && actions.contains(Action::Torsion))
        rows.add(rows.difference(rx), 0.0, 0.0);
    for (const BendingPlane plane : {BendingPlane::xy, BendingPlane::xz}) {
        const int v = local_row<kind>(force_axis(plane));
        const int phi = local_row<kind>(moment_axis(plane));
        const Action action = plane == BendingPlane::xy ? Action::BendingXY : Action::BendingXZ;
        if (v < 0 || phi < 0 || !actions.contains(action)) continue;
        const double bent = plane == BendingPlane::xy ? 1.0 : 0.0; // temperature bends in x'y' only
        rows.add(rows.difference(phi), 0.0, bent * L);
        Eigen::RowVectorXd chord = rows.difference(v);
        chord[phi] = -moment_sign(plane) * L;
        rows.add(chord, 0.0, 0.5 * bent * L * L);
    }
    return rows.over(B);
}

constexpr MemberProperties unit_properties{.axial = {1.0}, .torsion = {1.0}, .xy = {.EI = 1.0}, .xz = {.EI = 1.0}};

/// MemberElement behind the interface: from one member's data to what every pass asks of it.
template <AnalysisKind kind> class MemberOf final : public StraightMember {
public:
    using Core = MemberElement<kind>;
    static constexpr int m = Core::m;
    static constexpr int n = Core::n;

    explicit MemberOf(const MemberData& data)
        : StraightMember(data.stiffness_group), data_(data), n_end_dofs_(count_end_dofs())
    {}

    ElementDofs dofs() const override
    {
        return {.nodes = data_.nodes, .of_each_node = AnalysisModel<kind>::global, .n_own = n_end_dofs_};
    }

    bool is_constrained() const override
    {
        return data_.end_conditions != nullptr && data_.end_conditions->constraint != Constraint::None;
    }

    void stiffness(ElementMatrix& K) const override
    {
        const MemberGeometry geometry = this->geometry();
        const Core elastic = this->elastic(geometry);
        if (!is_constrained()) {
            K = elastic.stiffness();
            return;
        }
        const EndDisplacements ends = end_displacements(elastic);
        K = congruence(elastic.rigid_joint_stiffness(), ends.B) + ends.joint_stiffness();
    }

    PreciseMatrix precise_stiffness() const override
    {
        const MemberGeometry geometry = this->geometry();
        const Core elastic = this->elastic(geometry);
        if (!is_constrained()) return precise_stiffness_of(elastic.strains(), node_transformation(elastic));
        const EndDisplacements ends = end_displacements(elastic);
        return precise_stiffness_of(elastic.rigid_joint_strains(), ends.B) + ends.precise_joint_stiffness();
    }

    void equivalent_forces(const ElementLoads& loads, ElementVector& f) const override
    {
        const MemberGeometry geometry = this->geometry();
        SpanLoading own_room;
        SpanLoading& loading = loads.room != nullptr ? *loads.room : own_room;
        sort(loads.span_loads, geometry.length, loading);
        const Core elastic = this->elastic(geometry);
        if (!is_constrained()) {
            f = -elastic.fixed_end_forces(loading);
            return;
        }
        const Core constrained = this->constrained(geometry, *data_.properties);
        const Eigen::VectorXd fixed = elastic.rigid_joint_forces(loading) +
                                      constrained.rigid_joint_forces(loading.without_strain());
        f = -(end_displacements(elastic).B.transpose() * fixed);
        if (data_.end_conditions->is_bar) f.template head<2 * n>() -= elastic.simple_span_forces(loading);
    }

    Eigen::MatrixXd strains() const override
    {
        const MemberGeometry geometry = this->geometry();
        const Core elastic = this->elastic(geometry);
        if (!is_constrained()) return elastic.strains().B * node_transformation(elastic);
        const Core constrained = this->constrained(geometry, unit_properties);
        const EndDisplacements ends = end_displacements(elastic);
        const Eigen::MatrixXd between_ends = stacked(elastic.rigid_joint_strains().B,
                                                     constrained.rigid_joint_strains().B);
        return stacked(between_ends * ends.B, ends.sprung_gaps());
    }

    ConstraintRows constraint_rows() const override
    {
        const MemberGeometry geometry = this->geometry();
        return femoop::constraint_rows<kind>(constrained_actions(*data_.end_conditions), geometry.length,
                                             end_displacements(elastic(geometry)).B);
    }

    Eigen::MatrixXd constrained_stiffness() const override
    {
        const MemberGeometry geometry = this->geometry();
        const Core constrained = this->constrained(geometry, *data_.properties);
        return congruence(constrained.rigid_joint_stiffness(), end_displacements(constrained).B);
    }

    PreciseMatrix precise_constrained_stiffness() const override
    {
        const MemberGeometry geometry = this->geometry();
        const Core constrained = this->constrained(geometry, *data_.properties);
        return precise_stiffness_of(constrained.rigid_joint_strains(), end_displacements(constrained).B);
    }

    Eigen::MatrixXd resistance() const override
    {
        const MemberGeometry geometry = this->geometry();
        Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(2 * n, 2 * n);
        for (const Core& core : resisting(geometry)) {
            const Eigen::MatrixXd A = core.strains().B * node_transformation(core);
            sum += A.transpose() * A;
        }
        return sum;
    }

    Eigen::MatrixXd chord_rotations() const override
    {
        const MemberGeometry geometry = this->geometry();
        const Core elastic = this->elastic(geometry);
        Eigen::MatrixXd rows(3, 2 * n);
        for (const LocalAxis axis : {LocalAxis::x, LocalAxis::y, LocalAxis::z})
            rows.row(static_cast<Eigen::Index>(index(axis))) << -elastic.transformation_row(0, axis) / geometry.length,
                elastic.transformation_row(1, axis) / geometry.length;
        return rows;
    }

    std::vector<InternalMechanism> internal_mechanisms() const override
    {
        const MemberGeometry geometry = this->geometry();
        std::vector<InternalMechanism> found;
        for (const Core& core : resisting(geometry))
            for (const InternalMechanism& mechanism : core.internal_mechanisms()) found.push_back(mechanism);
        return found;
    }

    std::optional<InternalMechanism> loaded_twist(std::span<const SpanLoad> loads) const override
    {
        constexpr double negligible = 1e-9; // of the largest force
        if (loads.empty()) return std::nullopt;
        const MemberGeometry geometry = this->geometry();
        SpanLoading loading;
        sort(loads, geometry.length, loading);
        for (const Core& core : resisting(geometry)) {
            const auto forces = core.rigid_joint_forces(loading);
            for (const InternalMechanism& mechanism : core.internal_mechanisms(forces))
                if (mechanism.axis == LocalAxis::rx &&
                    std::abs(mechanism.work) > negligible * forces.cwiseAbs().maxCoeff())
                    return mechanism;
        }
        return std::nullopt;
    }

private:
    MemberGeometry geometry() const { return geometry_of(kind, data_); }

    Core core(const MemberGeometry& geometry, const MemberProperties& properties, ActionSet actions) const
    {
        return Core(properties, geometry, data_.end_conditions, actions);
    }
    /// What strains the member; to be used while its geometry lives.
    Core elastic(const MemberGeometry& geometry) const
    {
        const MemberEndConditions* conditions = data_.end_conditions;
        return core(geometry, *data_.properties, conditions == nullptr ? all_actions : elastic_actions(*conditions));
    }
    /// What its constraint takes from it.
    Core constrained(const MemberGeometry& geometry, const MemberProperties& properties) const
    {
        return core(geometry, properties, constrained_actions(*data_.end_conditions));
    }
    /// What resists in it: its stiffness and, if it has one, its constraint.
    std::vector<Core> resisting(const MemberGeometry& geometry) const
    {
        std::vector<Core> cores{elastic(geometry)};
        if (is_constrained()) cores.push_back(constrained(geometry, unit_properties));
        return cores;
    }

    /// Displacements of the ends from those of the nodes [2m x 2n].
    static Eigen::MatrixXd node_transformation(const Core& core)
    {
        Eigen::MatrixXd T = Eigen::MatrixXd::Zero(2 * m, 2 * n);
        T.topLeftCorner(m, n) = core.transformation(0);
        T.bottomRightCorner(m, n) = core.transformation(1);
        return T;
    }

    double joint(int end_row) const
    {
        const LocalAxis axis = AnalysisModel<kind>::local[static_cast<std::size_t>(end_row % m)];
        return data_.end_conditions->joints[static_cast<std::size_t>(end_row / m)][index(axis)];
    }

    std::uint32_t count_end_dofs() const
    {
        std::uint32_t count = 0;
        for (int row = 0; is_constrained() && row < 2 * m; ++row) count += std::isfinite(joint(row)) ? 1U : 0U;
        return count;
    }

    /// At a rigid joint the end follows its node; elsewhere it has a degree of freedom of its own.
    EndDisplacements end_displacements(const Core& core) const
    {
        const Eigen::MatrixXd T = node_transformation(core);
        const auto n_joints = static_cast<Eigen::Index>(n_end_dofs_);
        EndDisplacements ends{.B = Eigen::MatrixXd::Zero(2 * m, 2 * n + n_joints),
                              .gaps = Eigen::MatrixXd::Zero(n_joints, 2 * n + n_joints),
                              .joints = Eigen::VectorXd(n_joints)};
        Eigen::Index next = 0;
        for (int row = 0; row < 2 * m; ++row) {
            if (!std::isfinite(joint(row))) {
                ends.B.row(row).template head<2 * n>() = T.row(row);
                continue;
            }
            ends.B(row, 2 * n + next) = 1.0;
            ends.gaps.row(next).template head<2 * n>() = -T.row(row);
            ends.gaps(next, 2 * n + next) = 1.0;
            ends.joints[next++] = joint(row);
        }
        return ends;
    }

    void sort(std::span<const SpanLoad> loads, double length, SpanLoading& loading) const
    {
        const std::array<SpanLoading::Scaled, 1> terms{{{.loads = loads}}};
        data_.properties->xy.cut(loading, length, terms);
    }

    MemberData data_;
    std::uint32_t n_end_dofs_;
};

template <AnalysisKind kind> class BlockOf final : public MemberBlock {
public:
    BlockOf(std::size_t n, const std::function<MemberData(std::size_t)>& data)
    {
        members_.reserve(n);
        for (std::size_t i = 0; i < n; ++i) members_.emplace_back(data(i));
    }
    std::size_t size() const override { return members_.size(); }
    const StraightMember& operator[](std::size_t i) const override { return members_[i]; }

private:
    std::vector<MemberOf<kind>> members_;
};

} // namespace

MemberGeometry geometry_of(AnalysisKind kind, const MemberData& member)
{
    Eigen::Vector3d start = *member.positions[0], end = *member.positions[1];
    if (const MemberEndConditions* conditions = member.end_conditions) {
        start += conditions->offsets[0];
        end += conditions->offsets[1];
    }
    return member_geometry(kind, start, end, member.up == nullptr ? Eigen::Vector3d::Zero() : *member.up);
}

std::unique_ptr<const MemberBlock> make_members(AnalysisKind kind, std::size_t n,
                                                const std::function<MemberData(std::size_t)>& data)
{
    return with_model(kind, [&](auto k) -> std::unique_ptr<const MemberBlock> {
        return std::make_unique<BlockOf<decltype(k)::value>>(n, data);
    });
}

} // namespace femoop
