#include "femoop/plane/mesh/node_supports.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace femoop::plane {

namespace {

constexpr double parallel = 1e-6; // sine of the angle between directions that are one

const HeldDirection across_axis{.direction = Eigen::Vector2d::UnitX(), .dof = Dof::ux, .is_blocked = true};

double sine(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

Eigen::Vector2d left_of(const Eigen::Vector2d& direction) { return {-direction.y(), direction.x()}; }

Eigen::Vector2d direction_at(double degrees)
{
    const double angle = degrees * std::numbers::pi / 180.0;
    return {std::cos(angle), std::sin(angle)};
}

FieldPlace field_place(const Eigen::Vector2d& at) { return {.x = at.x(), .y = at.y()}; }

} // namespace

bool are_one(const HeldDirection& a, const HeldDirection& b)
{
    return std::abs(sine(a.direction, b.direction)) <= parallel;
}

CurveTable::CurveTable(const PlaneModel& model, const EdgeTable& table)
{
    for (const PlaneCurve& curve : model.curves) {
        edges.push_back(edges_along(model, table, curve).edges);
        geometry.emplace_back(model, edges.back(), curve.reach);
    }
}

void NodeSupport::add(const HeldDirection& held) { (held.is_blocked ? blocked_ : sprung_).push_back(held); }

/// The axes of the one direction that all have; nothing where two differ or there is none.
std::optional<NodeSupport::Axes> NodeSupport::axes(const std::vector<HeldDirection>& held) const
{
    if (held.empty()) return std::nullopt;
    const HeldDirection& first = held.front();
    for (const HeldDirection& each : held)
        if (!are_one(first, each)) return std::nullopt;
    const Eigen::Vector2d& d = first.direction;
    if (std::abs(d.x()) <= parallel * 1e-6) return Axes{.angle = 0.0, .along = Dof::uy};
    if (std::abs(d.y()) <= parallel * 1e-6) return Axes{.angle = 0.0, .along = Dof::ux};
    return Axes{.angle = std::atan2(d.y(), d.x()), .along = Dof::ux};
}

DofSet NodeSupport::blocked() const
{
    if (blocked_.empty()) return {};
    const auto one = axes(blocked_);
    return one ? DofSet{one->along} : DofSet{Dof::ux, Dof::uy};
}

double NodeSupport::angle() const
{
    if (const auto one = axes(blocked_)) return one->angle;
    if (!blocked_.empty()) return 0.0;
    const auto one = axes(sprung_);
    return one ? one->angle : 0.0;
}

DofSet NodeSupport::sprung() const
{
    if (sprung_.empty()) return {};
    if (const auto one = axes(sprung_); one && one->angle == angle()) return {one->along};
    return {Dof::ux, Dof::uy};
}

NodeSupports::NodeSupports(const PlaneModel& model, const CurveTable& curves)
    : model_(model), curves_(curves), of_node_(model.points.size())
{
    for (std::size_t i = 0; i < model.points.size(); ++i)
        if (model.points[i].support)
            for (const HeldDirection& held : held_by(*model.points[i].support, nullptr)) of_node_[i].add(held);
    for (std::size_t c = 0; c < model.curves.size(); ++c) {
        if (!model.curves[c].support) continue;
        for (const CurveNode& node : curves.geometry[c].nodes())
            for (const HeldDirection& held : held_by(*model.curves[c].support, &node))
                of_node_[node.node.index].add(held);
    }
}

std::vector<HeldDirection> NodeSupports::held_by(const PlaneSupport& support, const CurveNode* on_curve) const
{
    std::vector<Eigen::Vector2d> axes{direction_at(support.angle)};
    if (support.angle.value() == 0.0) axes = {Eigen::Vector2d::UnitX()};
    if (support.has_curve_axes() && on_curve != nullptr) axes = on_curve->directions;
    std::vector<HeldDirection> held;
    for (const Eigen::Vector2d& x : axes)
        for (const Dof dof : {Dof::ux, Dof::uy}) {
            const Eigen::Vector2d direction = dof == Dof::ux ? x : left_of(x);
            if (support.blocked().contains(dof))
                held.push_back({.direction = direction, .dof = dof, .is_blocked = true});
            for (const Spring& spring : support.springs)
                if (spring.dof == dof)
                    held.push_back({.direction = direction,
                                    .dof = dof,
                                    .is_blocked = false,
                                    .stiffness = on_curve == nullptr ? spring.stiffness.value() : 0.0});
        }
    return held;
}

std::vector<NodeSupports::Holder> NodeSupports::holders(NodeId node) const
{
    std::vector<Holder> found;
    if (model_[node].support) found.push_back({&*model_[node].support, nullptr});
    for (std::size_t c = 0; c < model_.curves.size(); ++c) {
        if (!model_.curves[c].support) continue;
        for (const CurveNode& on_curve : curves_.geometry[c].nodes())
            if (on_curve.node == node) found.push_back({&*model_.curves[c].support, &on_curve});
    }
    return found;
}

/// Each direction by the first support that holds it: a point may have none of its own and lie on a curve that has.
std::vector<ImposedMotion> NodeSupports::motions_of_point(const PlaneSettlement& settlement) const
{
    const NodeId node = *settlement.point;
    std::vector<ImposedMotion> all;
    for (const Dof dof : {Dof::ux, Dof::uy}) {
        const std::optional<Field>& field = dof == Dof::ux ? settlement.ux : settlement.uy;
        if (!field) continue;
        for (const auto& [support, on_curve] : holders(node)) {
            const std::size_t before = all.size();
            for (const HeldDirection& held : held_by(*support, on_curve))
                if (held.dof == dof) all.push_back({node, held, value(*field, field_place(position(model_[node])))});
            if (all.size() != before) break;
        }
    }
    return all;
}

std::vector<ImposedMotion> NodeSupports::motions(const PlaneSettlement& settlement) const
{
    std::vector<ImposedMotion> all;
    const auto impose = [&](NodeId node, const PlaneSupport& support, const CurveNode* on_curve, FieldPlace at) {
        for (const HeldDirection& held : held_by(support, on_curve)) {
            const std::optional<Field>& field = held.dof == Dof::ux ? settlement.ux : settlement.uy;
            if (field) all.push_back({.node = node, .held = held, .value = value(*field, at)});
        }
    };
    if (settlement.point)
        for (const ImposedMotion& motion : motions_of_point(settlement)) all.push_back(motion);
    for (const CurveId curve : settlement.curves) {
        if (!model_[curve].support) continue;
        const CurveGeometry& geometry = curves_.geometry[curve.index];
        for (const CurveNode& node : geometry.nodes()) {
            FieldPlace at = field_place(position(model_[node.node]));
            at.s = node.s;
            at.length = geometry.length();
            impose(node.node, *model_[curve].support, &node, at);
        }
    }
    return all;
}

bool NodeSupports::is_on_axis_of_revolution(NodeId node) const
{
    return model_.analysis == StressState::Axisymmetric && position(model_[node]).x() == 0.0;
}

ImposedDisplacement NodeSupports::displacement(NodeId node, std::vector<ImposedMotion> motions) const
{
    ImposedDisplacement found;
    if (motions.empty()) return found;
    if (is_on_axis_of_revolution(node))
        motions.insert(motions.begin(), {.node = node, .held = across_axis, .value = 0.0});
    for (const HeldDirection& blocked : (*this)[node].blocked_directions())
        if (std::none_of(motions.begin(), motions.end(),
                         [&](const ImposedMotion& each) { return are_one(each.held, blocked); }))
            motions.push_back({.node = node, .held = blocked, .value = 0.0});
    const ImposedMotion first = motions.front();
    std::optional<ImposedMotion> second;
    const auto along = [](const ImposedMotion& of, const HeldDirection& direction) {
        return of.held.direction.dot(direction.direction) < 0.0 ? -of.value : of.value;
    };
    for (const ImposedMotion& each : motions) {
        const bool is_first = are_one(each.held, first.held);
        if (!is_first && !second) second = each;
        if (!is_first && !are_one(each.held, second->held)) continue; // a third direction of two says nothing new
        const ImposedMotion& same = is_first ? first : *second;
        const double a = same.value, b = along(each, same.held);
        if (std::abs(a - b) > 1e-9 * std::max(std::abs(a), std::abs(b))) found.conflict = {a, b};
    }
    if (!second) {
        found.value = first.value * first.held.direction;
        return found;
    }
    Eigen::Matrix2d D;
    D << first.held.direction.transpose(), second->held.direction.transpose();
    found.value = D.inverse() * Eigen::Vector2d(first.value, second->value);
    return found;
}

} // namespace femoop::plane
