#include "femoop/element/continuum/continuum_element.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "femoop/element/continuum/continuum_model.h"
#include "femoop/element/continuum/element_geometry.h"
#include "femoop/solver/at_once.h"

namespace femoop {

namespace {

constexpr double nearly_on_axis = 1e-12; // of the element's largest radius: no digit of u / r is left

/// The element in one stress state: matrices of as many columns as its nodes ask for, without a heap.
template <StressState state> class ElementOfState final : public ContinuumElement {
public:
    ElementOfState(const ContinuumFormulation& formulation, std::span<const NodeId> nodes,
                   std::span<const Eigen::Vector2d> positions, std::uint32_t stiffness_group)
        : ContinuumElement(formulation, stiffness_group), positions_(positions)
    {
        std::ranges::copy(nodes, nodes_.begin());
    }

    ElementDofs dofs() const override { return {.nodes = nodes(), .of_each_node = plane_dofs}; }

    void stiffness(ElementMatrix& K) const override
    {
        const NodePositions X = node_positions();
        const Tangent D = tangent();
        const Dilatation dilatation = mean_dilatation(X);
        K.setZero(n_dofs(), n_dofs());
        for (const ShapeAtPoint& point : formulation().points()) {
            const Mapped mapped(point, X);
            const StrainMatrix B = strain_matrix(point.N, mapped, dilatation);
            const StrainMatrix DB = (point.weight * mapped.area * depth(mapped.at.x()) * D) * B;
            K.noalias() += B.transpose().lazyProduct(DB);
        }
        if constexpr (can_have_modes)
            if (has_modes()) {
                const Modes modes = mode_stiffness(X);
                const ModesToNodes amplitudes = modes.own_inverse * modes.to_nodes;
                K.noalias() -= modes.to_nodes.transpose().lazyProduct(amplitudes);
            }
    }

    void equivalent_forces(const ElementLoads& loads, ElementVector& f) const override
    {
        const NodePositions X = node_positions();
        f.setZero(n_dofs());
        for (const EdgeLoad& load : loads.edge_loads) add_edge_load(load, X, f);
        for (const BodyLoad& load : loads.body_loads) add_body_load(load, X, f);
        if (!loads.thermal_loads.empty()) add_heat(loads.thermal_loads, X, f);
    }

    Eigen::MatrixXd strains() const override
    {
        const NodePositions X = node_positions();
        const Dilatation dilatation = mean_dilatation(X);
        Eigen::MatrixXd all(n_strains * formulation().points().size(), n_dofs());
        for (Eigen::Index row = 0; const ShapeAtPoint& point : formulation().points()) {
            all.middleRows<n_strains>(row) = strain_matrix(point.N, Mapped(point, X), dilatation);
            row += n_strains;
        }
        return all;
    }

    Eigen::Vector2d place(NaturalPoint p) const override
    {
        return node_positions().transpose() * formulation().shape().values(p);
    }

    double volume(NaturalPoint p) const override
    {
        const Shape& shape = formulation().shape();
        const Mapped mapped({.at = p, .N = shape.values(p), .dN = shape.derivatives(p)}, node_positions());
        return mapped.area * depth(mapped.at.x());
    }

    StrainColumns total_strains(const ElementVector& u, std::span<const ShapeAtPoint> points, Heat heat) const override
    {
        const NodePositions X = node_positions();
        const Dilatation dilatation = mean_dilatation(X);
        StrainColumns strains(n_strains, points.size());
        for (Eigen::Index i = 0; const ShapeAtPoint& point : points)
            strains.col(i++) = strain_matrix(point.N, Mapped(point, X), dilatation).lazyProduct(u);
        if constexpr (can_have_modes)
            if (has_modes()) {
                const Modes modes = mode_stiffness(X);
                const Eigen::Vector4d forces = heat_on_modes(heat, X) - modes.to_nodes.lazyProduct(u);
                const Eigen::Vector4d amplitudes = modes.own_inverse * forces;
                for (Eigen::Index i = 0; const ShapeAtPoint& point : points)
                    strains.col(i++) += mode_matrix(point.at, Mapped(point, X), X) * amplitudes;
            }
        return strains;
    }

private:
    using Model = ContinuumModel<state>;
    static constexpr int n_strains = Model::n_strains;
    static constexpr int max_dofs = 2 * Shape::max_nodes;
    /// Row by row, so that the columns of B' stand together in products with it.
    template <int rows> using OfDofs = Eigen::Matrix<double, rows, Eigen::Dynamic, Eigen::RowMajor, rows, max_dofs>;
    using StrainMatrix = OfDofs<n_strains>;
    using Tangent = Eigen::Matrix<double, n_strains, n_strains>;
    static constexpr bool can_have_modes = state != StressState::Axisymmetric;
    static constexpr bool can_have_mean = n_strains == 4;

    /// ex + ey + ez of the node displacements: the mean of the element, where the formulation asks for it.
    using Dilatation = OfDofs<1>;
    using ModeMatrix = Eigen::Matrix<double, n_strains, 4>;
    using ModesToNodes = OfDofs<4>;
    /// Stiffness of the four amplitudes a of the modes: own a + to_nodes u = forces on them.
    struct Modes {
        Eigen::Matrix4d own_inverse;
        ModesToNodes to_nodes;
    };

    /// A natural point in the drawing.
    struct Mapped {
        Eigen::Vector2d at;
        Shape::Derivatives gradients; ///< of N by x and y
        double area;                  ///< det J
        double radius = 0.0;          ///< x; 0 on the axis of a body of revolution

        Mapped(const ShapeAtPoint& point, const NodePositions& X)
        {
            const Eigen::Matrix2d J = jacobian(point.dN, X);
            at = X.transpose().lazyProduct(point.N);
            area = J.determinant();
            gradients = point.dN * J.inverse().transpose();
            if constexpr (state == StressState::Axisymmetric)
                if (at.x() > nearly_on_axis * X.col(0).maxCoeff()) radius = at.x();
        }
    };

    int n_nodes() const { return formulation().shape().n_nodes(); }
    int n_dofs() const { return 2 * n_nodes(); }
    std::span<const NodeId> nodes() const { return {nodes_.data(), static_cast<std::size_t>(n_nodes())}; }

    NodePositions node_positions() const
    {
        NodePositions X(n_nodes(), 2);
        for (int i = 0; const NodeId node : nodes()) X.row(i++) = positions_[node.index];
        return X;
    }

    Tangent tangent() const { return formulation().material().tangent({.strain = StrainVector::Zero(n_strains)}); }

    double depth(double r) const { return Model::depth(formulation().thickness(), r); }

    bool has_mean() const { return can_have_mean && formulation().variant() == ElementVariant::MeanDilatation; }
    bool has_modes() const { return can_have_modes && formulation().variant() == ElementVariant::IncompatibleModes; }

    static StrainMatrix strain_matrix(const Shape::Values& N, const Mapped& mapped)
    {
        StrainMatrix B(n_strains, 2 * N.size());
        for (int i = 0; i < N.size(); ++i)
            B.template middleCols<2>(2 * i) = Model::B(N[i], mapped.gradients(i, 0), mapped.gradients(i, 1),
                                                       mapped.radius);
        return B;
    }

    /// With the mean dilatation in place of that of the point, a third in each direction.
    StrainMatrix strain_matrix(const Shape::Values& N, const Mapped& mapped, const Dilatation& mean) const
    {
        StrainMatrix B = strain_matrix(N, mapped);
        if constexpr (can_have_mean)
            if (has_mean()) {
                const Dilatation third = (mean - B.template topRows<3>().colwise().sum()) / 3.0;
                B.template topRows<3>().rowwise() += third;
            }
        return B;
    }

    Dilatation mean_dilatation(const NodePositions& X) const
    {
        Dilatation sum = Dilatation::Zero(n_dofs());
        if (!has_mean()) return sum;
        double volume = 0.0;
        for (const ShapeAtPoint& point : formulation().points()) {
            const Mapped mapped(point, X);
            const double part = point.weight * mapped.area * depth(mapped.at.x());
            if constexpr (can_have_mean)
                sum += part * strain_matrix(point.N, mapped).template topRows<3>().colwise().sum();
            volume += part;
        }
        return sum / volume;
    }

    /// Strains of the modes 1 - xi^2 and 1 - eta^2, each along x and y.
    static ModeMatrix mode_matrix(NaturalPoint p, const Mapped& mapped, const NodePositions& X)
    {
        const Eigen::Matrix2d J = jacobian(shape_of(ShapeKind::Q4).derivatives({}), X);
        Eigen::Matrix2d natural; // rows: modes, columns: d/dxi, d/deta
        natural << -2.0 * p.xi, 0.0, 0.0, -2.0 * p.eta;
        const Eigen::Matrix2d gradients = (J.determinant() / mapped.area) * natural * J.inverse().transpose();
        ModeMatrix G;
        for (int i = 0; i < 2; ++i)
            G.template middleCols<2>(2 * i) = Model::B(0.0, gradients(i, 0), gradients(i, 1), 0.0);
        return G;
    }

    Modes mode_stiffness(const NodePositions& X) const
    {
        const Tangent D = tangent();
        Eigen::Matrix4d own = Eigen::Matrix4d::Zero();
        Modes modes{.own_inverse = own, .to_nodes = ModesToNodes::Zero(4, n_dofs())};
        for (const ShapeAtPoint& point : formulation().points()) {
            const Mapped mapped(point, X);
            const ModeMatrix G = mode_matrix(point.at, mapped, X);
            const ModeMatrix DG = (point.weight * mapped.area * depth(mapped.at.x()) * D) * G;
            own += DG.transpose() * G;
            modes.to_nodes += DG.transpose() * strain_matrix(point.N, mapped);
        }
        modes.own_inverse = own.inverse();
        return modes;
    }

    /// D times the strain of heat at a point, over its volume.
    StressVector heat_stress(const ShapeAtPoint& point, const Mapped& mapped, Heat heat) const
    {
        const ConstitutiveModel& material = formulation().material();
        double rise = 0.0;
        for (const ThermalLoad& load : heat) rise += load.rise(mapped.at);
        return point.weight * mapped.area * depth(mapped.at.x()) *
               material.stress({.strain = material.thermal_strain(rise)});
    }

    Eigen::Vector4d heat_on_modes(Heat heat, const NodePositions& X) const
    {
        Eigen::Vector4d f = Eigen::Vector4d::Zero();
        if (heat.empty()) return f;
        for (const ShapeAtPoint& point : formulation().load_points()) {
            const Mapped mapped(point, X);
            f += mode_matrix(point.at, mapped, X).transpose() * heat_stress(point, mapped, heat);
        }
        return f;
    }

    void add_heat(Heat heat, const NodePositions& X, ElementVector& f) const
    {
        const Dilatation dilatation = mean_dilatation(X);
        for (const ShapeAtPoint& point : formulation().load_points()) {
            const Mapped mapped(point, X);
            f += strain_matrix(point.N, mapped, dilatation).transpose() * heat_stress(point, mapped, heat);
        }
        if constexpr (can_have_modes)
            if (has_modes()) {
                const Modes modes = mode_stiffness(X);
                f -= modes.to_nodes.transpose() * (modes.own_inverse * heat_on_modes(heat, X));
            }
    }

    void add_edge_load(const EdgeLoad& load, const NodePositions& X, ElementVector& f) const
    {
        double begin = -1.0;
        for (const double kink : load.kinks) add_between(std::exchange(begin, kink), kink, load, X, f);
        add_between(begin, 1.0, load, X, f);
    }

    void add_between(double begin, double end, const EdgeLoad& load, const NodePositions& X, ElementVector& f) const
    {
        const Shape& line = shape_of(*formulation().shape().edge_kind());
        for (ShapeAtPoint point : formulation().edge_points()) {
            if (end - begin < 2.0) point = between(begin, end, point, line);
            add_at(point, load, X, f);
        }
    }

    /// The point of a rule for a whole edge, as one for a part of it.
    static ShapeAtPoint between(double begin, double end, const ShapeAtPoint& of_whole, const Shape& line)
    {
        const double half = 0.5 * (end - begin);
        const NaturalPoint at{.xi = begin + half * (of_whole.at.xi + 1.0)};
        return {.at = at, .N = line.values(at), .dN = line.derivatives(at), .weight = half * of_whole.weight};
    }

    void add_at(const ShapeAtPoint& point, const EdgeLoad& load, const NodePositions& X, ElementVector& f) const
    {
        const Shape::Edge edge = formulation().shape().edges()[static_cast<std::size_t>(load.edge)];
        Eigen::Vector2d at = Eigen::Vector2d::Zero(), tangent = Eigen::Vector2d::Zero();
        for (std::size_t i = 0; i < edge.size(); ++i) {
            at += point.N[static_cast<int>(i)] * X.row(edge[i]).transpose();
            tangent += point.dN(static_cast<int>(i), 0) * X.row(edge[i]).transpose();
        }
        const double length = tangent.norm();
        const Eigen::Vector2d along = tangent / length;
        const Eigen::Vector2d traction = load.traction(
            {.at = at, .along = along, .outward = {along.y(), -along.x()}, .xi = point.at.xi});
        for (std::size_t i = 0; i < edge.size(); ++i)
            f.segment<2>(2 * edge[i]) += point.weight * length * depth(at.x()) * point.N[static_cast<int>(i)] *
                                         traction;
    }

    void add_body_load(const BodyLoad& load, const NodePositions& X, ElementVector& f) const
    {
        for (const ShapeAtPoint& point : formulation().load_points()) {
            const Mapped mapped(point, X);
            const Eigen::Vector2d force = point.weight * mapped.area * depth(mapped.at.x()) * load.force(mapped.at);
            for (int i = 0; i < n_nodes(); ++i) f.segment<2>(2 * i) += point.N[i] * force;
        }
    }

    std::span<const Eigen::Vector2d> positions_;
    std::array<NodeId, Shape::max_nodes> nodes_; ///< as many of them as the shape has
};

void refuse(const std::optional<GeometryFault>& fault)
{
    if (fault) throw std::invalid_argument(message(*fault));
}

void check_geometry(const ContinuumFormulation& formulation, std::span<const NodeId> nodes,
                    std::span<const Eigen::Vector2d> positions)
{
    const Shape& shape = formulation.shape();
    if (nodes.size() != static_cast<std::size_t>(shape.n_nodes()))
        refuse(GeometryFault{
            .flaw = GeometryFlaw::WrongNodeCount, .shape = shape.kind(), .value = static_cast<double>(nodes.size())});
    NodePositions X(shape.n_nodes(), 2);
    for (int i = 0; i < shape.n_nodes(); ++i) X.row(i) = positions[nodes[static_cast<std::size_t>(i)].index];
    if (formulation.state() == StressState::Axisymmetric) refuse(why_not_axisymmetric(shape, X));
    refuse(formulation.geometry_check().fault(X));
}

constexpr std::size_t elements_made_at_once = 10000; // that a thread makes

template <StressState state> class BlockOfState final : public ContinuumBlock {
public:
    using Own = ElementOfState<state>;

    BlockOfState(std::size_t n, std::span<const Eigen::Vector2d> positions, const ContinuumRows& rows) : elements_(n)
    {
        in_ranges(n, elements_made_at_once, [&](std::size_t begin, std::size_t end) {
            std::optional<Own>* next = elements_.data() + begin;
            rows(begin, end, [&](const ContinuumRow& row) {
                check_geometry(row.formulation, row.nodes, positions);
                next++->emplace(row.formulation, row.nodes, positions, row.stiffness_group);
            });
        });
    }
    std::size_t size() const override { return elements_.size(); }
    const ContinuumElement& operator[](std::size_t i) const override { return *elements_[i]; }

private:
    std::vector<std::optional<Own>> elements_;
};

} // namespace

StrainVector ContinuumElement::total_strain(const ElementVector& u, NaturalPoint p, Heat heat) const
{
    const Shape& shape = formulation_.shape();
    const ShapeAtPoint point{.at = p, .N = shape.values(p), .dN = shape.derivatives(p)};
    return total_strains(u, {&point, 1}, heat).col(0);
}

StrainVector ContinuumElement::mechanical_strain(const ElementVector& u, NaturalPoint p, Heat heat) const
{
    StrainVector strain = total_strain(u, p, heat);
    if (!heat.empty()) strain -= thermal_strain(p, heat);
    return strain;
}

StrainVector ContinuumElement::thermal_strain(NaturalPoint p, Heat heat) const
{
    double rise = 0.0;
    for (const ThermalLoad& load : heat) rise += load.rise(place(p));
    return formulation_.material().thermal_strain(rise);
}

std::unique_ptr<const ContinuumBlock> make_continuum_elements(StressState state, std::size_t n,
                                                              std::span<const Eigen::Vector2d> positions,
                                                              const ContinuumRows& rows)
{
    switch (state) {
    case StressState::PlaneStress: return std::make_unique<BlockOfState<StressState::PlaneStress>>(n, positions, rows);
    case StressState::PlaneStrain: return std::make_unique<BlockOfState<StressState::PlaneStrain>>(n, positions, rows);
    default: return std::make_unique<BlockOfState<StressState::Axisymmetric>>(n, positions, rows);
    }
}

std::unique_ptr<ContinuumElement> make_continuum_element(const ContinuumFormulation& formulation,
                                                         std::span<const NodeId> nodes,
                                                         std::span<const Eigen::Vector2d> positions,
                                                         std::uint32_t stiffness_group)
{
    check_geometry(formulation, nodes, positions);
    switch (formulation.state()) {
    case StressState::PlaneStress:
        return std::make_unique<ElementOfState<StressState::PlaneStress>>(formulation, nodes, positions,
                                                                          stiffness_group);
    case StressState::PlaneStrain:
        return std::make_unique<ElementOfState<StressState::PlaneStrain>>(formulation, nodes, positions,
                                                                          stiffness_group);
    default:
        return std::make_unique<ElementOfState<StressState::Axisymmetric>>(formulation, nodes, positions,
                                                                           stiffness_group);
    }
}

} // namespace femoop
