#include "apps/drawing/results/reactions.h"

#include "apps/drawing/loads/forces.h"
#include "apps/drawing/structure/plane_supports.h"
#include "apps/drawing/structure/supports.h"

#include <algorithm>
#include <cmath>

namespace drawing {

namespace {

using Eigen::Vector3d;
using femoop::Dof;

constexpr double noise = 1e-6; // of the largest reaction: below it a number is zero

struct Largest {
    double force = 0.0, moment = 0.0;
};

Largest largest_reactions(const Scene& scene, const SolvedCase& solved)
{
    Largest largest;
    for (std::size_t i = 0; i < scene.model.nodes.size(); ++i) {
        const femoop::NodeId node{i};
        if (!solved.result.is_supported(node)) continue;
        const femoop::NodeVector r = solved.result.reaction(node);
        for (const Dof dof : femoop::all_dofs) {
            double& most = femoop::is_rotation(dof) ? largest.moment : largest.force;
            most = std::max(most, std::abs(r[femoop::index(dof)]));
        }
    }
    // A moment that is noise beside force times size is zero though no other moment is there.
    largest.moment = std::max(largest.moment, 1e-3 * largest.force * scene.shape.size);
    largest.force = std::max(largest.force, 1e-3 * largest.moment / scene.shape.size);
    return largest;
}

bool has_spring(const Scene& scene, femoop::NodeId node, Dof dof)
{
    const auto& springs = scene.model[node].support->springs;
    return std::any_of(springs.begin(), springs.end(), [&](const auto& spring) { return spring.dof == dof; });
}

/// One component of a reaction, and what it has to keep clear of.
struct Reaction {
    femoop::NodeId node;
    Dof dof = Dof::ux;
    double value = 0.0;
    bool is_inside_arc = false; ///< a moment is drawn around the node

    Vector3d direction() const
    {
        const Vector3d axis = Vector3d::Unit(static_cast<int>(femoop::index(dof) % 3));
        return value < 0.0 ? Vector3d(-axis) : axis;
    }
};

/// Where an arrow clears the symbol: beyond it if they lie on one line, beside it else.
ForcePicture placed(const Scene& scene, const Reaction& reaction, const Vector3d& direction)
{
    ForcePicture force{.at = scene.shape[reaction.node], .direction = direction, .length = scene.sketch.px(36.0)};
    force.role = ui::Role::Reaction;
    force.touches = free_end(scene, reaction.node, direction);
    const auto side = support_side_in_model(scene, reaction.node);
    if (has_spring(scene, reaction.node, reaction.dof)) {
        force.gap = scene.sketch.px(46.0);
        return force;
    }
    if (!side) return force;
    const double along = side->dot(direction);
    if (std::abs(along) > 0.7) {
        force.touches = along < 0.0 ? ArrowAt::Head : ArrowAt::Tail;
        force.gap = scene.sketch.px(reaction.is_inside_arc ? 32.0 : 28.0);
        return force;
    }
    const double unit = 1.0 / scene.projection.scale();
    force.at += scene.sketch.px(reaction.is_inside_arc ? 4.0 : 12.0) * unit * *side;
    force.gap = scene.sketch.px(reaction.is_inside_arc ? 32.0 : 17.0);
    return force;
}

void draw_reaction(const Scene& scene, const Reaction& reaction)
{
    const double size = std::abs(reaction.value);
    const femoop::MovingEffect number{
        .quantity = femoop::ExpectedQuantity::Reaction, .node = reaction.node, .dof = reaction.dof};
    if (femoop::is_rotation(reaction.dof)) {
        draw_moment(scene, {.at = scene.shape[reaction.node],
                            .axis = reaction.direction(),
                            .text = scene.text(size, ui::Measure::Moment),
                            .role = ui::Role::Reaction,
                            .radius = 25.0,
                            .text_side = text_side(scene, reaction.node),
                            .number = number});
        return;
    }
    ForcePicture force = placed(scene, reaction, reaction.direction());
    force.text = scene.text(size, ui::Measure::Force);
    force.number = number;
    draw_force(scene, force);
}

/// Both components as the one force that they are.
void draw_resultant(const Scene& scene, const Reaction& along_normal, const Vector3d& normal)
{
    const double value = along_normal.value;
    ForcePicture force = placed(scene, along_normal, value < 0.0 ? Vector3d(-normal) : normal);
    force.text = "R = " + scene.text(std::abs(value), ui::Measure::Force);
    force.number = femoop::MovingEffect{.quantity = femoop::ExpectedQuantity::Reaction, .node = along_normal.node};
    draw_force(scene, force);
}

} // namespace

std::optional<Vector3d> slanting_normal(const femoop::Model& model, femoop::NodeId node)
{
    if (!model[node].support || !femoop::is_plane(model.analysis)) return std::nullopt;
    const femoop::Support& support = *model[node].support;
    const femoop::DofSet blocked = support.blocked(model.analysis);
    if (blocked.contains(Dof::ux) == blocked.contains(Dof::uy) || !support.springs.empty()) return std::nullopt;
    const Vector3d normal = plane_support_axes(support).at(blocked.contains(Dof::ux) ? 0 : 1);
    constexpr double upright = 1e-6;
    const bool is_slanting = std::abs(normal.x()) > upright && std::abs(normal.y()) > upright;
    return is_slanting ? std::optional(normal) : std::nullopt;
}

bool has_slanting_support(const femoop::Model& model)
{
    for (std::size_t i = 0; i < model.nodes.size(); ++i)
        if (slanting_normal(model, femoop::NodeId(i))) return true;
    return false;
}

double resultant(const femoop::NodeVector& reaction)
{
    return std::hypot(reaction[femoop::index(Dof::ux)], reaction[femoop::index(Dof::uy)]);
}

void draw_reactions(const Scene& scene, const SolvedCase& solved)
{
    const ui::LayerScope layer(scene.sketch.painter(), ui::Layer::Symbols);
    const Largest largest = largest_reactions(scene, solved);
    for (std::size_t i = 0; i < scene.model.nodes.size(); ++i) {
        const femoop::NodeId node{i};
        if (!scene.model[node].support || !solved.result.is_supported(node)) continue;
        const femoop::NodeVector r = solved.result.reaction(node);
        const auto is_there = [&](Dof dof) {
            const double most = femoop::is_rotation(dof) ? largest.moment : largest.force;
            return std::abs(r[femoop::index(dof)]) > noise * most;
        };
        const bool has_moment = scene.is_flat() && is_there(Dof::rz);
        for (const Dof dof : femoop::all_dofs)
            if (is_there(dof)) draw_reaction(scene, {node, dof, r[femoop::index(dof)], has_moment});
        const auto normal = scene.is_flat() ? slanting_normal(scene.model, node) : std::nullopt;
        const double along = normal ? normal->x() * r[0] + normal->y() * r[1] : 0.0;
        if (std::abs(along) > noise * largest.force) draw_resultant(scene, {node, Dof::ux, along, has_moment}, *normal);
    }
}

} // namespace drawing
