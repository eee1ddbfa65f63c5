#include "femoop/plane/analysis/plane_structure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

#include "femoop/element/continuum/foundation_element.h"
#include "femoop/material/linear_elastic.h"
#include "femoop/solver/at_once.h"

namespace femoop::plane {

namespace {

constexpr int foundation_degree = 4;                     // of two quadratic functions
constexpr std::size_t elements_worth_two_threads = 5000; // elements

IntegrationRule rule_of(ShapeKind kind, Formulation formulation, StressState analysis)
{
    return formulation == Formulation::Reduced ? gauss_quadrilateral(2) : standard_rule(kind, analysis);
}

ElementVariant variant_of(Formulation formulation)
{
    if (formulation == Formulation::BBar) return ElementVariant::MeanDilatation;
    return formulation == Formulation::Incompatible ? ElementVariant::IncompatibleModes : ElementVariant::Standard;
}

double density_of(const Material& material) { return material.density ? material.density->value() : 0.0; }

/// Nodes of a line's shape, in its order.
std::vector<NodeId> nodes_of(const CurveEdge& edge)
{
    std::vector<NodeId> nodes{edge.start, edge.end};
    if (edge.middle) nodes.push_back(*edge.middle);
    return nodes;
}

/// Nodes that have one displacement, by union and find.
class Groups {
public:
    explicit Groups(std::size_t n) : root_(n) { std::iota(root_.begin(), root_.end(), std::size_t{0}); }
    std::size_t find(std::size_t i)
    {
        while (root_[i] != i) i = root_[i] = root_[root_[i]];
        return i;
    }
    void join(std::size_t a, std::size_t b) { root_[std::max(find(a), find(b))] = std::min(find(a), find(b)); }

private:
    std::vector<std::size_t> root_;
};

/// Numbers that are equal where elements that follow one another are one that is moved along, to the digits that their
/// coordinates have: mapped meshes repeat themselves. 0 around an axis, where the radius counts.
class StiffnessRuns {
public:
    StiffnessRuns(std::span<const Eigen::Vector2d> positions, StressState analysis)
        : positions_(positions), is_of_revolution_(analysis == StressState::Axisymmetric)
    {
        constexpr double digits = 4.0 * std::numeric_limits<double>::epsilon();
        for (const Eigen::Vector2d& at : positions)
            negligible_ = std::max(negligible_, digits * at.cwiseAbs().maxCoeff());
    }

    /// Elements that follow one another and are one, beginning with `first`.
    struct Run {
        std::uint32_t number = 0; ///< none yet
        const ContinuumFormulation* formulation = nullptr;
        const std::vector<NodeId>* first = nullptr; ///< nodes of the first element
    };

    /// The number of the run that an element goes on with, or begins: its own then.
    std::uint32_t next(Run& run, std::size_t element, const ContinuumFormulation& formulation,
                       const std::vector<NodeId>& nodes) const
    {
        if (is_of_revolution_) return 0;
        if (run.number == 0 || &formulation != run.formulation || !is_moved_along(*run.first, nodes))
            run = {.number = static_cast<std::uint32_t>(element + 1), .formulation = &formulation, .first = &nodes};
        return run.number;
    }

private:
    bool is_moved_along(const std::vector<NodeId>& first, const std::vector<NodeId>& nodes) const
    {
        const Eigen::Vector2d by = at(nodes[0]) - at(first[0]);
        for (std::size_t i = 1; i < nodes.size(); ++i)
            if (!((at(nodes[i]) - at(first[i]) - by).cwiseAbs().maxCoeff() <= negligible_)) return false;
        return true;
    }
    const Eigen::Vector2d& at(NodeId node) const { return positions_[node.index]; }

    std::span<const Eigen::Vector2d> positions_;
    bool is_of_revolution_;
    double negligible_ = 0.0;
};

} // namespace

Eigen::Matrix2d spring_matrix(const std::vector<HeldDirection>& held)
{
    Eigen::Matrix2d k = Eigen::Matrix2d::Zero();
    for (const HeldDirection& each : held) k += each.stiffness * each.direction * each.direction.transpose();
    return k;
}

PlaneStructure::PlaneStructure(PlaneModel model) : model_(std::move(model)), positions_(plane::positions(model_))
{
    add_materials();
    const auto add_mesh = [&] {
        edges_.emplace(model_);
        curves_.emplace(model_, *edges_);
        supports_.emplace(model_, *curves_);
        list_elements_of_nodes();
    };
    if (model_.elements.size() < elements_worth_two_threads) {
        add_mesh();
        add_elements();
    } else at_once(add_mesh, [&] { add_elements(); });
    Discretisation structure{.kind = AnalysisKind::Truss2d}; // its nodes have ux and uy
    const std::size_t n = positions_.size();
    for (const Eigen::Vector2d& at : positions_) structure.positions.emplace_back(at.x(), at.y(), 0.0);
    structure.support_of_node.assign(n, -1);
    structure.is_attached.assign(n, false);
    for (const PlaneElement& element : model_.elements)
        for (const NodeId node : element.points) structure.is_attached[node.index] = true;
    structure.bodies.reserve(elements_->size());
    for (std::size_t e = 0; e < elements_->size(); ++e) structure.bodies.emplace_back(elements_, &(*elements_)[e]);
    add_supports(structure);
    add_ties(structure);
    add_foundations(structure);
    discretisation_ = std::make_shared<const Discretisation>(std::move(structure));
}

void PlaneStructure::list_elements_of_nodes()
{
    elements_start_.assign(positions_.size() + 1, 0);
    for (const PlaneElement& element : model_.elements)
        for (const NodeId node : element.points) ++elements_start_[node.index + 1];
    std::partial_sum(elements_start_.begin(), elements_start_.end(), elements_start_.begin());
    elements_of_.resize(elements_start_.back());
    std::vector<std::uint32_t> next(elements_start_.begin(), elements_start_.end() - 1);
    for (std::size_t e = 0; e < model_.elements.size(); ++e)
        for (const NodeId node : model_.elements[e].points)
            elements_of_[next[node.index]++] = static_cast<std::uint32_t>(e);
}

std::vector<Location> PlaneStructure::locations(NodeId node, RegionId region) const
{
    std::vector<Location> found;
    for (const std::uint32_t e : elements_of(node)) {
        const PlaneElement& element = model_.elements[e];
        if (element.region != region) continue;
        const auto i = std::ranges::find(element.points, node) - element.points.begin();
        found.push_back({.element = ElementId(e), .at = shape_of(element.kind).nodes()[static_cast<std::size_t>(i)]});
    }
    return found;
}

const Locator& PlaneStructure::locator() const
{
    std::call_once(is_located_, [this] { locator_ = std::make_unique<const Locator>(model_); });
    return *locator_;
}

void PlaneStructure::add_materials()
{
    for (const PlaneRegion& region : model_.regions) {
        const Material& material = model_[region.material];
        materials_.push_back(std::make_unique<LinearElastic>(
            ElasticConstants{
                .E = material.E, .nu = material.poisson(), .alpha = material.alpha ? material.alpha->value() : 0.0},
            model_.analysis));
    }
}

/// Made where they are missing, of every element.
std::vector<const ContinuumFormulation*> PlaneStructure::formulations_of_elements()
{
    std::map<std::pair<std::uint32_t, ShapeKind>, const ContinuumFormulation*> known;
    std::vector<const ContinuumFormulation*> all;
    all.reserve(model_.elements.size());
    for (const PlaneElement& element : model_.elements) {
        const ContinuumFormulation*& formulation = known[{element.region.index, element.kind}];
        if (formulation == nullptr) {
            const Formulation chosen = model_.formulation(element.region);
            formulations_.push_back(std::make_unique<ContinuumFormulation>(
                shape_of(element.kind), rule_of(element.kind, chosen, model_.analysis),
                *materials_[element.region.index], model_.thickness(element.region), variant_of(chosen),
                density_of(model_[model_[element.region].material])));
            formulation = formulations_.back().get();
        }
        all.push_back(formulation);
    }
    return all;
}

void PlaneStructure::add_elements()
{
    const std::vector<const ContinuumFormulation*> formulations = formulations_of_elements();
    const StiffnessRuns runs(positions_, model_.analysis);
    const auto rows = [&](std::size_t begin, std::size_t end, const auto& add) {
        StiffnessRuns::Run run;
        for (std::size_t e = begin; e < end; ++e) {
            const std::vector<NodeId>& nodes = model_.elements[e].points;
            const std::uint32_t group = runs.next(run, e, *formulations[e], nodes);
            add({.formulation = *formulations[e], .nodes = nodes, .stiffness_group = group});
        }
    };
    elements_ = make_continuum_elements(model_.analysis, model_.elements.size(), positions_, rows);
}

void PlaneStructure::add_supports(Discretisation& structure) const
{
    for (std::size_t i = 0; i < positions_.size(); ++i) {
        NodeSupport support = (*supports_)[NodeId(i)];
        if (supports_->is_on_axis_of_revolution(NodeId(i)))
            support.add({.direction = Eigen::Vector2d::UnitX(), .dof = Dof::ux, .is_blocked = true});
        if (!support.is_held()) continue;
        structure.support_of_node[i] = static_cast<std::int32_t>(structure.supports.size());
        structure.supports.push_back({.node = NodeId(i),
                                      .blocked = support.blocked(),
                                      .angle = support.angle(),
                                      .on_foundations = support.sprung()});
    }
}

/// One displacement for all nodes of tied curves; where one of them is blocked, all are.
void PlaneStructure::add_ties(Discretisation& structure) const
{
    for (const Dof dof : {Dof::ux, Dof::uy}) {
        Groups groups(positions_.size());
        bool has_ties = false;
        for (std::size_t c = 0; c < model_.curves.size(); ++c) {
            if (!model_.curves[c].tie.contains(dof)) continue;
            has_ties = true;
            for (const CurveNode& node : curves_->geometry[c].nodes())
                groups.join(node.node.index, curves_->geometry[c].nodes().front().node.index);
        }
        if (!has_ties) continue;
        std::vector<std::size_t> leader(positions_.size());
        std::iota(leader.begin(), leader.end(), std::size_t{0});
        for (const Discretisation::SupportRow& support : structure.supports)
            if (support.blocked.contains(dof)) leader[groups.find(support.node.index)] = support.node.index;
        for (std::size_t i = 0; i < positions_.size(); ++i)
            if (const std::size_t other = leader[groups.find(i)]; other != i)
                structure.ties.push_back({.node = NodeId(i), .dof = dof, .leader = NodeId(other)});
    }
}

void PlaneStructure::add_foundations(Discretisation& structure)
{
    for (std::size_t c = 0; c < model_.curves.size(); ++c) {
        const PlaneCurve& curve = model_.curves[c];
        if (!curve.support || curve.support->springs.empty()) continue;
        for (std::size_t e = 0; e < curves_->edges[c].size(); ++e) {
            sprung_edges_.push_back({CurveId(c), e});
            structure.foundations.push_back(edge_foundation(CurveId(c), e));
        }
    }
    for (std::size_t i = 0; i < model_.points.size(); ++i) {
        if (!model_.points[i].support || model_.points[i].support->springs.empty()) continue;
        std::vector<HeldDirection> own; // springs of curves have no stiffness here
        for (const HeldDirection& held : (*supports_)[NodeId(i)].springs())
            if (held.stiffness > 0.0) own.push_back(held);
        FoundationElement::Point point{.N = Shape::Values::Ones(1), .area = 1.0, .k = spring_matrix(own), .place = {}};
        point.place.at = positions_[i];
        sprung_points_.emplace_back(i);
        structure.foundations.push_back(
            std::make_shared<FoundationElement>(std::vector{NodeId(i)}, std::vector{point}));
    }
}

/// Springs per area of the face: the axes of a curve follow its edge.
std::shared_ptr<const Element> PlaneStructure::edge_foundation(CurveId curve, std::size_t edge) const
{
    const CurveEdge& along = curves_->edges[curve.index][edge];
    const PlaneSupport& support = *model_[curve].support;
    const std::vector<NodeId> nodes = nodes_of(along);
    const Shape& line = shape_of(nodes.size() == 2 ? ShapeKind::Line2 : ShapeKind::Line3);
    const RegionId region = model_[(along.left ? along.left : along.right)->element].region;
    std::vector<FoundationElement::Point> points;
    for (const ShapeAtPoint& at : tabulated(line, rule_of_degree(Domain::Line, 2 * foundation_degree))) {
        Eigen::Vector2d place = Eigen::Vector2d::Zero(), tangent = Eigen::Vector2d::Zero();
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            place += at.N[static_cast<Eigen::Index>(i)] * positions_[nodes[i].index];
            tangent += at.dN(static_cast<Eigen::Index>(i), 0) * positions_[nodes[i].index];
        }
        const double depth = model_.analysis == StressState::Axisymmetric ? 2.0 * std::numbers::pi * place.x()
                                                                          : model_.thickness(region);
        const Eigen::Vector2d direction = tangent.normalized();
        const double angle = support.angle * std::numbers::pi / 180.0;
        const Eigen::Vector2d x = support.has_curve_axes() ? direction
                                                           : Eigen::Vector2d(std::cos(angle), std::sin(angle));
        std::vector<HeldDirection> held;
        for (const Spring& spring : support.springs)
            held.push_back({.direction = spring.dof == Dof::ux ? x : Eigen::Vector2d(-x.y(), x.x()),
                            .dof = spring.dof,
                            .stiffness = spring.stiffness});
        points.push_back({.N = at.N,
                          .area = at.weight * tangent.norm() * depth,
                          .k = spring_matrix(held),
                          .place = {.at = place, .along = x, .outward = {}, .xi = at.at.xi}});
    }
    return std::make_shared<FoundationElement>(nodes, std::move(points));
}

} // namespace femoop::plane
