#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "femoop/model/quantity/number_text.h"
#include "femoop/plane/check/plane_checker.h"

namespace femoop::plane {

void PlaneChecker::check_load_cases()
{
    for (std::size_t i = 0; i < model_.load_cases.size(); ++i) {
        const PlaneLoadCase& load_case = model_.load_cases[i];
        const std::string path = Entry{"load_cases", i, {}}.text();
        check_self_weight(load_case, {"load_cases", i, load_case.id});
        const auto check_each = [&](const auto& loads, const char* key, const auto& unreadable) {
            const std::string list = path + key;
            for (std::size_t j = 0; j < loads.size(); ++j) {
                is_partial_ = flag(unreadable, i, j);
                check_load(loads[j], {list, j, {}});
            }
            is_partial_ = false;
        };
        check_each(load_case.points, ".points", unreadable_.point_loads);
        check_each(load_case.curves, ".curves", unreadable_.curve_loads);
        check_each(load_case.regions, ".regions", unreadable_.region_loads);
        check_each(load_case.settlements, ".settlements", unreadable_.settlements);
    }
    if (supports_ && !has_errors()) check_settlements();
}

template <class Use> void PlaneChecker::for_regions(const std::vector<RegionId>& regions, Use use) const
{
    std::vector<RegionId> wanted = regions;
    if (wanted.empty())
        for (std::size_t i = 0; i < model_.regions.size(); ++i) wanted.emplace_back(i);
    for (const RegionId region : wanted)
        if (region.index < model_.regions.size() && is_readable(model_[region].material))
            use(model_[region], model_[model_[region].material]);
}

void PlaneChecker::require_density(const std::vector<RegionId>& regions, const Entry& place)
{
    for_regions(regions, [&](const PlaneRegion& region, const Material& material) {
        if (!material.density) add(FaultKind::RegionWithoutDensity, place, {material.id, region.id});
    });
}

void PlaneChecker::require_expansion(const std::vector<RegionId>& regions, const Entry& place)
{
    for_regions(regions, [&](const PlaneRegion& region, const Material& material) {
        if (!material.alpha) add(FaultKind::RegionWithoutExpansion, place, {material.id, region.id});
    });
}

void PlaneChecker::check_self_weight(const PlaneLoadCase& load_case, const Entry& place)
{
    if (require_finite(place, "self_weight", load_case.self_weight) && load_case.self_weight != 0.0)
        require_density({}, place);
}

void PlaneChecker::check_load(const NodeLoad& load, const Entry& place)
{
    const bool has_point = require_entry(place, "points", load.node.index, model_.points.size());
    require_distinct(place, load.components);
    if (load.components.empty()) add(FaultKind::EmptyLoad, place, {});
    bool is_loaded = false;
    for (const Component& part : load.components) {
        require_finite(place, force_name(part.dof), part.value);
        is_loaded = is_loaded || part.value.value() != 0.0;
    }
    if (is_loaded && has_point && has_no_elements(load.node))
        add(FaultKind::PointWithoutElements, place, {model_[load.node].id});
}

void PlaneChecker::check_load(const CurveLoad& load, const Entry& place)
{
    for (const CurveId curve : load.curves) require_entry(place, "curves", curve.index, model_.curves.size());
    for (const CurveId curve : load.curves) check_sides(load.kind, curve, place);
    if (load.kind == CurveLoadKind::Pressure) return check_field(load.value, "value", true, place);
    if (!load.qx && !load.qy) add(FaultKind::EmptyLoad, place, {});
    check_field(load.qx, "qx", true, place);
    check_field(load.qy, "qy", true, place);
    if (load.kind == CurveLoadKind::Line && model_.analysis == StressState::Axisymmetric)
        add(FaultKind::LineLoadOfRevolution, place, {});
}

/// What a force per area asks of a curve with material on both sides.
void PlaneChecker::check_sides(CurveLoadKind kind, CurveId curve, const Entry& place)
{
    if (kind == CurveLoadKind::Line || curve.index >= model_.curves.size() || unreadable_.is_incomplete) return;
    for (const CurveEdge& edge : edges_along(model_, *edges_, model_[curve]).edges) {
        if (!edge.left || !edge.right) continue;
        if (kind == CurveLoadKind::Pressure) return add(FaultKind::PressureInside, place, {model_[curve].id});
        const RegionId left = model_[edge.left->element].region, right = model_[edge.right->element].region;
        if (model_.thickness(left) != model_.thickness(right))
            return add(FaultKind::LoadOnTwoThicknesses, place, {model_[curve].id, model_[left].id, model_[right].id});
    }
}

void PlaneChecker::check_load(const RegionLoad& load, const Entry& place)
{
    for (const RegionId region : load.regions) require_entry(place, "regions", region.index, model_.regions.size());
    if (const auto* body = std::get_if<BodyForce>(&load.load)) {
        if (!body->bx && !body->by) add(FaultKind::EmptyLoad, place, {});
        check_field(body->bx, "bx", false, place);
        check_field(body->by, "by", false, place);
    } else if (const auto* heat = std::get_if<TemperatureRise>(&load.load)) {
        check_field(heat->rise, "rise", false, place);
        require_expansion(load.regions, place);
    } else {
        const auto& rotation = std::get<SteadyRotation>(load.load);
        require_finite(place, "omega", rotation.omega);
        if (!rotation.about.empty() && model_.analysis == StressState::Axisymmetric)
            add(FaultKind::AboutOfRevolution, place, {});
        require_density(load.regions, place);
    }
}

void PlaneChecker::check_field(const std::optional<Field>& field, std::string_view key, bool is_on_curve,
                               const Entry& place)
{
    if (!field) return;
    const auto require = [&](const Quantity& number) { require_finite(place, key, number); };
    if (const auto* constant = std::get_if<Quantity>(&field->form)) require(*constant);
    if (const auto* ends = std::get_if<Field::Ends>(&field->form)) require(ends->start), require(ends->end);
    if (const auto* terms = std::get_if<Field::Polynomial>(&field->form))
        for (const Field::Term& term : *terms) require(term.factor);
    if (const auto* table = std::get_if<Field::Table>(&field->form))
        for (const auto& [at, number] : table->rows) require(at), require(number);
    if (!is_on_curve && needs_curve(*field)) {
        const std::string path = place.text() + "." + std::string(key);
        add(FaultKind::FieldNeedsCurve, {path, {}, {}}, {});
    }
}

void PlaneChecker::check_load(const PlaneSettlement& settlement, const Entry& place)
{
    const bool is_on_curve = !settlement.curves.empty();
    if (!settlement.ux && !settlement.uy) add(FaultKind::EmptyLoad, place, {});
    check_field(settlement.ux, "ux", is_on_curve, place);
    check_field(settlement.uy, "uy", is_on_curve, place);
    const auto is_held = [](const std::optional<PlaneSupport>& support, Dof dof) {
        return support && (support->blocked().contains(dof) ||
                           std::ranges::any_of(support->springs, [&](const Spring& s) { return s.dof == dof; }));
    };
    for (const Dof dof : {Dof::ux, Dof::uy}) {
        if (!(dof == Dof::ux ? settlement.ux : settlement.uy)) continue;
        for (const CurveId curve : settlement.curves)
            if (curve.index < model_.curves.size() && !flag(unreadable_.curves, curve.index) &&
                !is_held(model_[curve].support, dof))
                add(FaultKind::SettlementOfFreeCurve, place, {std::string(name(dof)), model_[curve].id});
        if (!settlement.point || !supports_ || settlement.point->index >= model_.points.size()) continue;
        PlaneSettlement alone = settlement;
        (dof == Dof::ux ? alone.uy : alone.ux).reset();
        alone.curves.clear();
        if (supports_->motions(alone).empty())
            add(FaultKind::SettlementOfFreeDof, place, {std::string(name(dof)), model_[*settlement.point].id});
    }
}

void PlaneChecker::check_settlements()
{
    for (std::size_t i = 0; i < model_.load_cases.size(); ++i) {
        MotionsOfNodes of_node;
        for (const PlaneSettlement& settlement : model_.load_cases[i].settlements)
            for (const ImposedMotion& motion : supports_->motions(settlement)) of_node[motion.node].push_back(motion);
        const auto conflict = conflict_of(of_node);
        if (!conflict) continue;
        const auto text = [this](double length) { return shown(Quantity(length), dimension::length); };
        const Entry place{"load_cases", i, model_.load_cases[i].id};
        const auto& [node, a, b] = *conflict;
        if (a == 0.0 && supports_->is_on_axis_of_revolution(node))
            add(FaultKind::SettlementOffAxis, place, {model_[node].id, text(b)});
        else add(FaultKind::SettlementConflict, place, {model_[node].id, text(a), text(b)});
    }
}

/// Of one node, or of nodes that a curve ties.
std::optional<PlaneChecker::Conflict> PlaneChecker::conflict_of(const MotionsOfNodes& of_node) const
{
    for (const auto& [node, motions] : of_node)
        if (const auto conflict = supports_->displacement(node, motions).conflict)
            return Conflict{node, (*conflict)[0], (*conflict)[1]};
    if (of_node.empty()) return std::nullopt;
    for (std::size_t i = 0; i < model_.curves.size(); ++i)
        for (const Dof dof : {Dof::ux, Dof::uy}) {
            if (!model_.curves[i].tie.contains(dof)) continue;
            std::optional<double> first;
            for (const CurveNode& each : curves_->geometry[i].nodes()) {
                const NodeSupport& support = (*supports_)[each.node];
                if (support.angle() != 0.0 || !support.blocked().contains(dof)) continue;
                const auto found = of_node.find(each.node);
                const double moved = found == of_node.end()
                                         ? 0.0
                                         : supports_->displacement(each.node, found->second).value[index(dof)];
                if (first && std::abs(moved - *first) > 1e-9 * std::max(std::abs(moved), std::abs(*first)))
                    return Conflict{each.node, *first, moved};
                first = moved;
            }
        }
    return std::nullopt;
}

} // namespace femoop::plane
