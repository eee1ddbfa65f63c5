#include <cmath>
#include <map>
#include <utility>

#include "femoop/plane/analysis/edge_traction.h"
#include "femoop/plane/analysis/plane_structure.h"
#include "femoop/plane/mesh/mesh_geometry.h"

namespace femoop::plane {

namespace {

constexpr double standard_gravity_acceleration = 9.80665; // m/s^2

} // namespace

/// The loads of one load case as numbers.
class PlaneLoads {
public:
    PlaneLoads(const PlaneStructure& structure, const PlaneLoadCase& load_case)
        : structure_(structure), model_(structure.model()), case_(load_case)
    {}

    CaseLoads loads()
    {
        for (const NodeLoad& load : case_.points) {
            CaseLoads::OnNode row{.node = load.node};
            for (const Component& part : load.components) row.value[index(part.dof)] += part.value;
            loads_.nodes.push_back(row);
        }
        for (const CurveLoad& load : case_.curves)
            for (const CurveId curve : load.curves) add(load, curve);
        for (const RegionLoad& load : case_.regions) add(load);
        if (case_.self_weight != 0.0) add_self_weight();
        add_settlements();
        for (auto& [element, on] : on_element_) loads_.elements.push_back(std::move(on));
        return std::move(loads_);
    }

private:
    CaseLoads::OnElement& on(std::size_t element)
    {
        CaseLoads::OnElement& found = on_element_[element];
        found.element = element;
        return found;
    }

    void add(const CurveLoad& load, CurveId curve)
    {
        const std::vector<CurveEdge>& edges = structure_.curves().edges[curve.index];
        for (std::size_t i = 0; i < edges.size(); ++i) {
            const ElementEdge& side = edges[i].left ? *edges[i].left : *edges[i].right;
            const double thickness = model_.thickness(model_[side.element].region);
            const EdgeTraction traction{.load = &load,
                                        .curve = &structure_.curves().geometry[curve.index],
                                        .edge = i,
                                        .is_reversed = !edges[i].left,
                                        .per_area = load.kind == CurveLoadKind::Line ? 1.0 / thickness : 1.0};
            on(side.element.index)
                .edge_loads.push_back({.edge = side.edge, .traction = traction, .kinks = traction.kinks()});
        }
    }

    template <class Use> void for_elements(const std::vector<RegionId>& regions, Use use)
    {
        std::vector<bool> is_wanted(model_.regions.size(), regions.empty());
        for (const RegionId region : regions) is_wanted[region.index] = true;
        for (std::size_t e = 0; e < model_.elements.size(); ++e)
            if (is_wanted[model_.elements[e].region.index]) use(e, model_[model_[model_.elements[e].region].material]);
    }

    void add(const RegionLoad& load)
    {
        if (const auto* body = std::get_if<BodyForce>(&load.load))
            for_elements(load.regions, [&](std::size_t e, const Material&) {
                on(e).body_loads.push_back({[body](const Eigen::Vector2d& at) {
                    return Eigen::Vector2d(value_or_zero(body->bx, place_of(at)),
                                           value_or_zero(body->by, place_of(at)));
                }});
            });
        else if (const auto* heat = std::get_if<TemperatureRise>(&load.load))
            for_elements(load.regions, [&](std::size_t e, const Material&) {
                on(e).thermal_loads.push_back(
                    {[heat](const Eigen::Vector2d& at) { return value_or_zero(heat->rise, place_of(at)); }});
            });
        else add_rotation(std::get<SteadyRotation>(load.load), load.regions);
    }

    void add_rotation(const SteadyRotation& rotation, const std::vector<RegionId>& regions)
    {
        Eigen::Vector2d about = Eigen::Vector2d::Zero();
        if (!rotation.about.empty()) about = {rotation.about[0], rotation.about[1]};
        const bool is_plane = model_.analysis != StressState::Axisymmetric;
        for_elements(regions, [&](std::size_t e, const Material& material) {
            const double factor = *material.density * rotation.omega * rotation.omega;
            on(e).body_loads.push_back({[=](const Eigen::Vector2d& at) {
                return Eigen::Vector2d(factor * (at.x() - about.x()), is_plane ? factor * (at.y() - about.y()) : 0.0);
            }});
        });
    }

    void add_self_weight()
    {
        const double g = case_.self_weight * standard_gravity_acceleration / metres(model_.units.length);
        for_elements({}, [&](std::size_t e, const Material& material) {
            const double weight = *material.density * g;
            on(e).body_loads.push_back({[weight](const Eigen::Vector2d&) { return Eigen::Vector2d(0.0, -weight); }});
        });
    }

    void add_settlements()
    {
        std::map<NodeId, std::vector<ImposedMotion>> blocked, sprung;
        for (const PlaneSettlement& settlement : case_.settlements) {
            for (const ImposedMotion& motion : structure_.supports().motions(settlement))
                (motion.held.is_blocked ? blocked : sprung)[motion.node].push_back(motion);
            for (const CurveId curve : settlement.curves) add_moving_ground(settlement, curve);
        }
        for (const auto& [node, motions] : blocked) add_displacement(node, motions);
        for (const auto& [node, motions] : sprung) add_moving_ground(node, motions);
    }

    void add_displacement(NodeId node, const std::vector<ImposedMotion>& motions)
    {
        const Discretisation& structure = *structure_.discretisation();
        const Eigen::Vector2d u = structure_.supports().displacement(node, motions).value;
        const double angle = structure.support_of(node)->angle, c = std::cos(angle), s = std::sin(angle);
        CaseLoads::OnNode row{.node = node};
        row.value[0] = angle == 0.0 ? u.x() : c * u.x() + s * u.y();
        row.value[1] = angle == 0.0 ? u.y() : c * u.y() - s * u.x();
        for (const Discretisation::Tie& tie : structure.ties)
            if (tie.node == node) row.value[index(tie.dof)] = 0.0; // it goes where its leader goes
        loads_.settlements.push_back(row);
        for (const Discretisation::Tie& tie : structure.ties)
            if (tie.leader == node) {
                CaseLoads::OnNode follower{.node = tie.node};
                follower.value[index(tie.dof)] = row.value[index(tie.dof)];
                loads_.settlements.push_back(follower);
            }
    }

    /// Of the springs of a point.
    void add_moving_ground(NodeId node, const std::vector<ImposedMotion>& motions)
    {
        for (std::size_t i = 0; i < structure_.sprung_points_.size(); ++i) {
            if (structure_.sprung_points_[i] != node) continue;
            Eigen::Vector2d push = Eigen::Vector2d::Zero();
            for (const ImposedMotion& motion : motions)
                push += motion.held.stiffness * motion.value * motion.held.direction;
            on(first_foundation() + structure_.sprung_edges_.size() + i)
                .edge_loads.push_back({.edge = 0, .traction = [push](const EdgePoint&) { return push; }});
        }
    }

    /// Of the springs along a curve.
    void add_moving_ground(const PlaneSettlement& settlement, CurveId curve)
    {
        const std::optional<PlaneSupport>& support = model_[curve].support;
        for (std::size_t i = 0; i < structure_.sprung_edges_.size(); ++i) {
            const auto& [of_curve, edge] = structure_.sprung_edges_[i];
            if (of_curve != curve) continue;
            const CurveGeometry* const geometry = &structure_.curves().geometry[curve.index];
            const std::size_t edge_index = edge; // clang 14 captures no bindings
            on(first_foundation() + i)
                .edge_loads.push_back(
                    {.edge = 0, .traction = [=, &settlement, &support](const EdgePoint& point) {
                         FieldPlace at = place_of(point.at);
                         at.s = geometry->s(edge_index, point.xi);
                         at.length = geometry->length();
                         Eigen::Vector2d push = Eigen::Vector2d::Zero();
                         for (const Spring& spring : support->springs) {
                             const bool is_x = spring.dof == Dof::ux;
                             const Eigen::Vector2d direction = is_x
                                                                   ? point.along
                                                                   : Eigen::Vector2d(-point.along.y(), point.along.x());
                             push += spring.stiffness * value_or_zero(is_x ? settlement.ux : settlement.uy, at) *
                                     direction;
                         }
                         return push;
                     }});
        }
    }

    std::size_t first_foundation() const { return model_.elements.size(); }

    const PlaneStructure& structure_;
    const PlaneModel& model_;
    const PlaneLoadCase& case_;
    CaseLoads loads_;
    std::map<std::size_t, CaseLoads::OnElement> on_element_;
};

std::vector<CaseLoads> PlaneStructure::loads() const
{
    std::vector<CaseLoads> all;
    for (const PlaneLoadCase& load_case : model_.load_cases) all.push_back(PlaneLoads(*this, load_case).loads());
    return all;
}

} // namespace femoop::plane
