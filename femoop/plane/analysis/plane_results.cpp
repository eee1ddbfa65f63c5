#include "femoop/plane/analysis/plane_results.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "femoop/algebra/dense_solution.h"
#include "femoop/plane/analysis/patch_recovery.h"
#include "femoop/plane/mesh/mesh_geometry.h"
#include "femoop/solver/at_once.h"

namespace femoop::plane {

namespace {

using Values = Eigen::Matrix<double, 8, 1>; ///< sx sy sz txy ex ey ez gxy

PlaneStress stress_of(const StressVector& s)
{
    if (s.size() == 3) return {.sx = s[0], .sy = s[1], .sz = 0.0, .txy = s[2]};
    return {.sx = s[0], .sy = s[1], .sz = s[2], .txy = s[3]};
}

PlaneStress stress_in(const Values& values) { return {values[0], values[1], values[2], values[3]}; }
PlaneStrain strain_in(const Values& values) { return {values[4], values[5], values[6], values[7]}; }

StressVector vector_of(const PlaneStress& s, StressState state)
{
    StressVector v(n_components(state));
    if (state == StressState::PlaneStress) v << s.sx, s.sy, s.txy;
    else v << s.sx, s.sy, s.sz, s.txy;
    return v;
}

constexpr int points_of_piece = 8;                      // of Gauss's rule along a part of a cut
constexpr std::size_t elements_sampled_at_once = 10000; // that a thread does
constexpr double round_off = 1e-13; // of what a motion of the whole body would be if it were all strain

/// The largest E.
double stiffest(const PlaneModel& model)
{
    double most = 0.0;
    for (const Material& material : model.materials) most = std::max(most, material.E.value());
    return most;
}

} // namespace

struct PlaneCase::Samples {
    SampleNumbers numbers;
    ValueTable values; ///< [recovery points x 8]
    bool are_stressed = true;
};

struct PlaneCase::Recovered {
    PatchRecovery recovery;
    ValueTable values; ///< [nodal values x 8]
};

PlaneResults::PlaneResults(std::shared_ptr<const PlaneStructure> structure,
                           std::shared_ptr<const detail::Solution> solution, AnalysisStatistics statistics)
    : structure_(std::move(structure)), solution_(std::move(solution)), statistics_(std::move(statistics))
{}

PlaneCase PlaneResults::operator[](CaseId id) const { return {structure_, solution_, id.index}; }

PlaneCase::PlaneCase(std::shared_ptr<const PlaneStructure> structure, std::shared_ptr<const detail::Solution> solution,
                     std::size_t index)
    : structure_(std::move(structure)),
      solution_(std::move(solution)),
      terms_(solution_->cases[index]),
      displacements_(2 * structure_->positions().size(), 0.0),
      reactions_(solution_->structure->supports.size())
{
    for (const auto& [load_case, factor] : terms_.terms) {
        const detail::CaseSolution& each = solution_->solutions[load_case];
        for (std::size_t i = 0; i < displacements_.size(); ++i) displacements_[i] += factor * each.displacements[i];
        for (std::size_t s = 0; s < reactions_.size(); ++s)
            for (std::size_t i = 0; i < n_dofs; ++i) reactions_[s][i] += factor * each.reactions[s][i];
        for (const CaseLoads::OnElement& on : solution_->loads[load_case].elements)
            for (const ThermalLoad& load : on.thermal_loads) {
                const double times = factor; // clang 14 captures no bindings
                const auto* const rise = &load.rise;
                heat_[on.element].push_back({[rise, times](const Eigen::Vector2d& at) { return times * (*rise)(at); }});
            }
    }
    drop_round_off_of_reactions();
}

/// What springs under a body that moves with them do by rounding is nothing.
void PlaneCase::drop_round_off_of_reactions()
{
    double force = 0.0, depth = 0.0;
    for (const NodeVector& each : reactions_)
        for (const double component : each) force = std::max(force, std::abs(component));
    const PlaneModel& model = structure_->model();
    for (std::size_t r = 0; r < model.regions.size(); ++r) depth = std::max(depth, model.thickness(RegionId(r)));
    if (force <= round_off * stiffest(model) * depth * largest_motion()) std::ranges::fill(reactions_, NodeVector{});
}

double PlaneCase::largest_motion() const
{
    double most = 0.0;
    for (const double u : displacements_) most = std::max(most, std::abs(u));
    return most;
}

double PlaneCase::motion_as_strain(ElementId element) const
{
    const PlaneModel& model = structure_->model();
    return field(element).node_displacements().cwiseAbs().maxCoeff() / extent(positions_of(model, model[element]));
}

Eigen::Vector2d PlaneCase::displacement(NodeId node) const
{
    return {displacements_[2 * node.index], displacements_[2 * node.index + 1]};
}

ElementField PlaneCase::field(ElementId element) const
{
    const auto heat = heat_.find(element.index);
    return {structure_->element(element), displacements_,
            heat == heat_.end() ? ContinuumElement::Heat() : ContinuumElement::Heat(heat->second)};
}

Eigen::Vector2d PlaneCase::displacement(const Location& place) const
{
    return field(place.element).displacement(place.at);
}

bool PlaneCase::is_supported(NodeId node) const { return structure_->supports()[node].is_held(); }

/// An axis holds its nodes by itself, which is no reaction.
Eigen::Vector2d PlaneCase::reaction(NodeId node) const
{
    const NodeSupport& support = structure_->supports()[node];
    const std::int32_t row = solution_->structure->support_of_node[node.index];
    if (row < 0 || !support.is_held()) return Eigen::Vector2d::Zero();
    const NodeVector& force = reactions_[static_cast<std::size_t>(row)];
    DofSet held = support.blocked();
    for (const Dof dof : all_dofs)
        if (support.sprung().contains(dof)) held.insert(dof);
    const bool is_on_axis = structure_->supports().is_on_axis_of_revolution(node);
    return {is_on_axis && !held.contains(Dof::ux) ? 0.0 : force[0], force[1]};
}

Eigen::Vector2d PlaneCase::reaction(const std::vector<NodeId>& nodes) const
{
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const NodeId node : nodes) sum += reaction(node);
    return sum;
}

double PlaneCase::reaction_moment(const std::vector<NodeId>& nodes, const Eigen::Vector2d& about) const
{
    double sum = 0.0;
    for (const NodeId node : nodes) {
        const Eigen::Vector2d arm = structure_->positions()[node.index] - about, force = reaction(node);
        sum += arm.x() * force.y() - arm.y() * force.x();
    }
    return sum;
}

Equilibrium PlaneCase::equilibrium() const
{
    Equilibrium sum;
    const bool has_reactions = std::ranges::any_of(reactions_,
                                                   [](const NodeVector& each) { return each != NodeVector{}; });
    for (const auto& [load_case, factor] : terms_.terms) {
        const Equilibrium& each = solution_->solutions[load_case].equilibrium;
        sum.residual = std::max(sum.residual, each.residual);
        for (std::size_t i = 0; i < n_dofs; ++i) {
            sum.sum_loads[i] += factor * each.sum_loads[i];
            if (has_reactions) sum.sum_reactions[i] += factor * each.sum_reactions[i];
        }
    }
    return sum;
}

const PlaneCase::Samples& PlaneCase::samples() const
{
    if (samples_) return *samples_;
    const PlaneModel& model = structure_->model();
    auto made = std::make_shared<Samples>(Samples{SampleNumbers(model), {}});
    made->values.resize(static_cast<Eigen::Index>(made->numbers.size()), 8);
    in_ranges(model.elements.size(), elements_sampled_at_once, [&](std::size_t begin, std::size_t end) {
        for (std::size_t e = begin; e < end; ++e) {
            const PlaneElement& element = model.elements[e];
            const ElementField inside = field(ElementId(e));
            const std::span<const ShapeAtPoint> points = recovery_points(element.kind);
            const ContinuumElement::StrainColumns totals = inside.strains(points);
            auto row = static_cast<Eigen::Index>(made->numbers.first(ElementId(e)));
            for (Eigen::Index i = 0; const ShapeAtPoint& point : points) {
                const StrainVector total = totals.col(i++);
                StrainVector mechanical = total;
                if (inside.is_warmed()) mechanical -= inside.thermal_strain(point.at);
                made->values.row(row++) = values_of(element.region, total, mechanical);
            }
        }
    });
    drop_round_off(*made);
    samples_ = std::move(made);
    return *samples_;
}

/// A body that moves as a whole, or swells freely, has no stress; what it has by rounding is none.
void PlaneCase::drop_round_off(Samples& samples) const
{
    const PlaneModel& model = structure_->model();
    const double most = samples.values.leftCols<4>().cwiseAbs().maxCoeff();
    constexpr double surely_none = 1e-7; // even where elements are a millionth of the body
    if (most > surely_none * stiffest(model) * largest_motion() / extent(structure_->positions())) return;
    double strain = 0.0, stress = 0.0; // if elements gave way by all of their displacements
    for (std::size_t e = 0; e < model.elements.size(); ++e) {
        const double of_motion = motion_as_strain(ElementId(e));
        strain = std::max(strain, of_motion);
        stress = std::max(stress, model[model[model.elements[e].region].material].E * of_motion);
    }
    samples.are_stressed = most > round_off * stress;
    if (!samples.are_stressed) samples.values.leftCols<4>().setZero();
    if (samples.values.rightCols<4>().cwiseAbs().maxCoeff() <= round_off * strain)
        samples.values.rightCols<4>().setZero();
}

Eigen::Matrix<double, 8, 1> PlaneCase::values_of(RegionId region, const StrainVector& total,
                                                 const StrainVector& mechanical) const
{
    const PlaneStress s = stress_of(structure_->material(region).stress({.strain = mechanical}));
    Values values;
    values << s.sx, s.sy, s.sz, s.txy, total[0], total[1], 0.0, total[total.size() - 1];
    if (total.size() == 4) values[6] = total[2];
    else { // a sheet contracts across: nu / E times its stresses, and what heat adds
        const PlaneModel& model = structure_->model();
        const Material& material = model[model[region].material];
        values[6] = -material.poisson() / material.E * (s.sx + s.sy) + (total[0] - mechanical[0]);
    }
    return values;
}

/// Where the recovery points lie, in the order of the samples.
ValueTable PlaneCase::sample_places() const
{
    const PlaneModel& model = structure_->model();
    ValueTable places(samples().values.rows(), 2);
    for (Eigen::Index row = 0; const PlaneElement& element : model.elements) {
        const NodePositions X = positions_of(model, element);
        for (const ShapeAtPoint& point : recovery_points(element.kind)) places.row(row++) = point.N.transpose() * X;
    }
    return places;
}

const PlaneCase::Recovered& PlaneCase::recovered() const
{
    if (recovered_) return *recovered_;
    auto made = std::make_shared<Recovered>(Recovered{PatchRecovery(structure_->model()), {}});
    made->values = made->recovery.nodal_values(samples().values, sample_places());
    recovered_ = std::move(made);
    return *recovered_;
}

void PlaneCase::sample() const { static_cast<void>(samples()); }
void PlaneCase::recover() const { static_cast<void>(recovered()); }

Values PlaneCase::element_values(const Location& place) const
{
    const Samples& from = samples();
    const ShapeKind kind = structure_->model()[place.element].kind;
    const RecoveryWeights weights = extrapolation(kind, place.at);
    const auto first = static_cast<Eigen::Index>(from.numbers.first(place.element));
    Values sum = Values::Zero();
    for (Eigen::Index i = 0; i < weights.size(); ++i) sum += weights[i] * from.values.row(first + i).transpose();
    return sum;
}

Values PlaneCase::recovered_values(const Location& place) const
{
    return recovered_values(place.element, shape_of(structure_->model()[place.element].kind).values(place.at));
}

Values PlaneCase::recovered_values(ElementId element, const Shape::Values& N) const
{
    const Recovered& from = recovered();
    Values sum = Values::Zero();
    for (Eigen::Index i = 0; i < N.size(); ++i)
        sum += N[i] *
               from.values.row(static_cast<Eigen::Index>(from.recovery.slot(element, static_cast<std::size_t>(i))))
                   .transpose();
    return sum;
}

PlaneStress PlaneCase::element_stress(const Location& place) const { return stress_in(element_values(place)); }

PlaneStress PlaneCase::element_stress(const std::vector<Location>& places, RegionId region) const
{
    Values sum = Values::Zero();
    int n = 0;
    for (const Location& place : places)
        if (structure_->model()[place.element].region == region) {
            sum += element_values(place);
            ++n;
        }
    return stress_in(n > 0 ? Values(sum / n) : sum);
}

PlaneStress PlaneCase::smoothed_stress(const Location& place) const { return stress_in(recovered_values(place)); }
PlaneStrain PlaneCase::smoothed_strain(const Location& place) const { return strain_in(recovered_values(place)); }

PlaneStress PlaneCase::smoothed_stress(ElementId element, const Shape::Values& N) const
{
    return stress_in(recovered_values(element, N));
}

PlaneStress PlaneCase::smoothed_stress(NodeId node, RegionId region) const
{
    return smoothed_stress(structure_->locations(node, region).front());
}
PlaneStrain PlaneCase::smoothed_strain(NodeId node, RegionId region) const
{
    return smoothed_strain(structure_->locations(node, region).front());
}
PlaneStress PlaneCase::element_stress(NodeId node, RegionId region) const
{
    return element_stress(structure_->locations(node, region), region);
}

void PlaneCase::at_integration_points(
    ElementId element, const std::function<void(const Eigen::Vector2d&, const PlaneStress&)>& visit) const
{
    const ElementField inside = field(element);
    for (const IntegrationPoint& point : structure_->element(element).formulation().rule().points)
        visit(inside.place(point.at), samples().are_stressed ? stress_of(inside.stress(point.at)) : PlaneStress{});
}

double PlaneCase::energy() const
{
    if (!samples().are_stressed) return 0.0;
    double twice = 0.0;
    for (std::size_t e = 0; e < structure_->model().elements.size(); ++e) {
        const ContinuumElement& element = structure_->element(ElementId(e));
        const ElementField inside = field(ElementId(e));
        for (const IntegrationPoint& point : element.formulation().rule().points) {
            const StrainVector strain = inside.mechanical_strain(point.at);
            twice += point.weight * element.volume(point.at) *
                     strain.dot(element.formulation().material().stress({.strain = strain}));
        }
    }
    return 0.5 * twice;
}

const std::vector<double>& PlaneCase::element_errors() const
{
    if (element_errors_) return *element_errors_;
    const StressState state = structure_->model().analysis;
    std::vector<double> errors;
    double of_whole = 0.0, of_motion = 0.0; // of_motion: as if the displacements were all strain
    for (std::size_t e = 0; e < structure_->model().elements.size(); ++e) {
        const ContinuumElement& element = structure_->element(ElementId(e));
        const ElementField inside = field(ElementId(e));
        const TangentMatrix D = element.formulation().material().tangent(
            {.strain = StrainVector::Zero(n_components(state))});
        const TangentMatrix compliance = dense_inverse(D);
        const double motion = motion_as_strain(ElementId(e));
        double of_error = 0.0;
        for (const IntegrationPoint& point : element.formulation().rule().points) {
            const StressVector smooth = vector_of(smoothed_stress({.element = ElementId(e), .at = point.at}), state);
            const StressVector error = smooth - inside.stress(point.at);
            const double volume = point.weight * element.volume(point.at);
            of_error += volume * error.dot(compliance * error);
            of_whole += volume * smooth.dot(compliance * smooth);
            of_motion += volume * D.diagonal().maxCoeff() * motion * motion;
        }
        errors.push_back(std::max(of_error, 0.0));
    }
    constexpr double rounding = 1e-12; // stresses of a body that moves freely, which have no digit
    const bool is_strained = of_whole > rounding * rounding * of_motion;
    for (double& error : errors) error = is_strained ? std::sqrt(error / of_whole) : 0.0;
    element_errors_ = std::make_shared<const std::vector<double>>(std::move(errors));
    return *element_errors_;
}

double PlaneCase::error_estimate() const
{
    double sum = 0.0;
    for (const double error : element_errors()) sum += error * error;
    return std::sqrt(sum);
}

/// sx', sy', txy' at a place of a cut, the mean of the elements that hold it.
Eigen::Vector3d PlaneCase::stress_on(const Cut& cut, const CutPiece& piece, double s, StressMeasure measure) const
{
    const PlaneModel& model = structure_->model();
    const Eigen::Vector2d at = cut.at(s), n = cut.normal(), t = cut.along();
    Values sum = Values::Zero();
    for (const ElementId element : piece.elements) {
        const PlaneElement& e = model[element];
        const NaturalPlace place = natural_place(shape_of(e.kind), positions_of(model, e), at);
        const double depth = measure == StressMeasure::PerLength ? model.thickness(e.region) : 1.0;
        sum += depth * element_values({.element = element, .at = place.at});
    }
    const PlaneStress mean = stress_in(sum / static_cast<double>(piece.elements.size()));
    Eigen::Matrix2d S;
    S << mean.sx, mean.txy, mean.txy, mean.sy;
    return {n.dot(S * n), t.dot(S * t), t.dot(S * n)};
}

std::vector<Eigen::Vector2d> PlaneCase::node_forces(ElementId id) const
{
    const ContinuumElement& element = structure_->element(id);
    ElementMatrix K;
    element.stiffness(K);
    ElementVector sum = K * field(id).node_displacements();
    for (const auto& [load_case, factor] : terms_.terms)
        for (const CaseLoads::OnElement& on : solution_->loads[load_case].elements) {
            if (on.element != id.index) continue;
            ElementVector f;
            element.equivalent_forces(on.loads(), f);
            sum -= factor * f;
        }
    std::vector<Eigen::Vector2d> forces;
    for (Eigen::Index i = 0; i + 1 < sum.size(); i += 2) forces.emplace_back(sum[i], sum[i + 1]);
    return forces;
}

CutForces PlaneCase::forces(const Cut& cut) const
{
    static const IntegrationRule rule = gauss_line(points_of_piece);
    const std::vector<CutPiece> pieces = pieces_along(structure_->model(), structure_->locator(), cut);
    double length = 0.0, first_moment = 0.0;
    for (const CutPiece& piece : pieces) {
        length += piece.to - piece.from;
        first_moment += 0.5 * (piece.to + piece.from) * (piece.to - piece.from);
    }
    const double middle = length > 0.0 ? first_moment / length : 0.0;
    CutForces sum;
    for (const CutPiece& piece : pieces)
        for (const IntegrationPoint& point : rule.points) {
            const double half = 0.5 * (piece.to - piece.from), s = piece.from + half * (1.0 + point.at.xi);
            const Eigen::Vector3d flow = stress_on(cut, piece, s, StressMeasure::PerLength);
            const double part = point.weight * half;
            sum.N += part * flow[0];
            sum.V -= part * flow[2];
            sum.M -= part * flow[0] * (s - middle);
        }
    return sum;
}

std::vector<CutStation> PlaneCase::stations(const Cut& cut) const
{
    std::vector<CutStation> stations;
    for (const CutPiece& piece : pieces_along(structure_->model(), structure_->locator(), cut))
        for (const double s : {piece.from, 0.5 * (piece.from + piece.to), piece.to}) {
            const Eigen::Vector3d stress = stress_on(cut, piece, s, StressMeasure::PerArea);
            stations.push_back({.s = s, .at = cut.at(s), .sx = stress[0], .sy = stress[1], .txy = stress[2]});
        }
    return stations;
}

} // namespace femoop::plane
