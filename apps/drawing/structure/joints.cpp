#include "apps/drawing/sketch/symbols.h"
#include "apps/drawing/structure/members.h"

namespace drawing {

namespace {

using femoop::Dof;
using femoop::DofSet;

constexpr double hinge_radius = 4.6;

DofSet rotations_in(DofSet set)
{
    DofSet rotations;
    for (const Dof dof : {Dof::rx, Dof::ry, Dof::rz})
        if (set.contains(dof)) rotations.insert(dof);
    return rotations;
}

void draw_ring(const Scene& scene, ui::Point center, double radius)
{
    scene.sketch.disc(center, radius, scene.sketch.theme().fill(ui::Role::Hinge));
    scene.sketch.ring(center, radius, scene.sketch.stroke(ui::Role::Hinge));
}

std::string names(DofSet dofs)
{
    std::string list;
    for (const Dof dof : femoop::all_dofs)
        if (dofs.contains(dof)) list += (list.empty() ? "" : " ") + std::string(femoop::name(dof));
    return list;
}

/// One end of a member: a frame at its end, x into the member.
struct End {
    const femoop::MemberEnd& joint;
    SymbolFrame frame;
    double cursor;          ///< where the next symbol begins, pixels from the end
    bool is_pinned = false; ///< the end of a bar among beams
};

void note(const Scene& scene, const End& end, double at, const std::string& text)
{
    scene.sketch.caption({.text = text,
                          .role = ui::Role::Spring,
                          .target = end.frame(at, 0.0),
                          .toward = end.frame.y,
                          .gap = scene.sketch.px(9.0),
                          .rank = Rank::Minor,
                          .size = scene.sketch.theme().type().small});
}

void draw_hinge(const Scene& scene, End& end)
{
    const DofSet released = rotations_in(end.joint.release);
    if (released.is_empty()) return;
    const double r = scene.sketch.px(hinge_radius);
    const double at = end.cursor + r;
    draw_ring(scene, end.frame(at, 0.0), r);
    end.cursor = at + r + scene.sketch.px(2.0);
    // In space a hinge turns about some axes only; plane models have but one.
    const bool has_many = scene.model.analysis == femoop::AnalysisKind::Frame3d;
    const bool is_usual = released.contains(Dof::ry) && released.contains(Dof::rz);
    const bool is_twist = scene.model.analysis == femoop::AnalysisKind::Grillage && !released.contains(Dof::rz);
    if ((has_many && !is_usual) || is_twist) note(scene, end, at, names(released));
}

// A sleeve in which the member's end slides along its axis.
void draw_axial_release(const Scene& scene, End& end)
{
    if (!end.joint.release.contains(Dof::ux)) return;
    Sketch& sketch = scene.sketch;
    const double a = end.cursor;
    const double b = a + sketch.px(16.0);
    const double h = sketch.px(5.0);
    const SymbolFrame& f = end.frame;
    sketch.polygon({f(a, h), f(b, h), f(b, -h), f(a, -h)}, sketch.theme().background());
    sketch.polyline({f(b, h), f(a, h), f(a, -h), f(b, -h)}, sketch.stroke(ui::Role::Hinge));
    sketch.line(f(a + sketch.px(6.0), 0.0), f(b, 0.0), sketch.stroke(ui::Role::Member));
    end.cursor = b + sketch.px(3.0);
}

// Two plates that slide past one another, square to the axis.
void draw_shear_release(const Scene& scene, End& end)
{
    const bool is_released = end.joint.release.contains(Dof::uy) || end.joint.release.contains(Dof::uz);
    if (!is_released) return;
    Sketch& sketch = scene.sketch;
    const double a = end.cursor;
    const double b = a + sketch.px(7.0);
    const double h = sketch.px(10.0);
    const SymbolFrame& f = end.frame;
    sketch.polygon({f(a, h), f(b, h), f(b, -h), f(a, -h)}, sketch.theme().background());
    sketch.line(f(a, -h), f(a, h), sketch.stroke(ui::Role::Hinge));
    sketch.line(f(b, -h), f(b, h), sketch.stroke(ui::Role::Hinge));
    for (const double y : {-0.55, 0.55})
        sketch.ring(f(0.5 * (a + b), y * h), 0.32 * (b - a), sketch.thin(ui::Role::Hinge));
    end.cursor = b + sketch.px(3.0);
}

void draw_end_spring(const Scene& scene, End& end, const femoop::Spring& spring)
{
    Sketch& sketch = scene.sketch;
    const bool turns = femoop::is_rotation(spring.dof);
    const double size = sketch.px(8.0);
    const double at = end.cursor + size;
    sketch.disc(end.frame(at, 0.0), size, sketch.theme().background());
    if (turns) draw_spiral(sketch, end.frame.moved(at, 0.0), size);
    else draw_zigzag(sketch, end.frame.moved(end.cursor, 0.0), 2.0 * size, 0.6 * size);
    end.cursor = at + size + sketch.px(3.0);
    if (!scene.explains()) return;
    const auto measure = turns ? ui::Measure::MomentPerAngle : ui::Measure::ForcePerLength;
    note(scene, end, at, "k = " + scene.text(spring.stiffness, measure));
}

void draw_end(const Scene& scene, End end)
{
    if (end.is_pinned) {
        const double r = scene.sketch.px(0.8 * hinge_radius);
        draw_ring(scene, end.frame(end.cursor + r, 0.0), r);
        end.cursor += 2.0 * r + scene.sketch.px(2.0);
    } else {
        draw_hinge(scene, end);
    }
    draw_axial_release(scene, end);
    draw_shear_release(scene, end);
    for (const femoop::Spring& spring : end.joint.springs) draw_end_spring(scene, end, spring);
}

} // namespace

void draw_end_joint(const Scene& scene, femoop::MemberId id, std::size_t end, const Eigen::Vector3d& aside)
{
    const femoop::Member& member = scene.model[id];
    const MemberShape& shape = scene.shape[id];
    const bool is_start = end == 0, is_hinge = scene.model[member.nodes.at(end)].hinge;
    const bool is_pinned = member.bar && !femoop::is_truss(scene.model.analysis) && !is_hinge;
    const double gap = scene.sketch.px(is_hinge ? 4.0 + hinge_radius : 4.0);
    const Eigen::Vector3d at = (is_start ? shape.start : shape.end) + aside,
                          along = is_start ? shape.x() : Eigen::Vector3d(-shape.x());
    draw_end(scene,
             {is_start ? member.start : member.end, scene.projection.frame(at, along, shape.y()), gap, is_pinned});
}

void draw_node_joint(const Scene& scene, femoop::NodeId node, const Eigen::Vector3d& aside)
{
    const ui::Point place = scene.projection(scene.shape[node] + aside);
    const bool is_truss = femoop::is_truss(scene.model.analysis);
    if (is_truss || scene.model[node].hinge) draw_ring(scene, place, scene.sketch.px(is_truss ? 3.6 : hinge_radius));
    else scene.sketch.disc(place, scene.sketch.px(3.0), scene.sketch.theme().fill(ui::Role::Node));
}

void draw_joints(const Scene& scene)
{
    const ui::LayerScope layer(scene.sketch.painter(), ui::Layer::Symbols);
    const Eigen::Vector3d here = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < scene.model.members.size(); ++i)
        for (const std::size_t end : {0U, 1U}) draw_end_joint(scene, femoop::MemberId{i}, end, here);
    const auto is_seen = [&](femoop::NodeId node) { // under slim members no dot is
        return femoop::is_truss(scene.model.analysis) || scene.model[node].hinge || !scene.detail.is_reduced() ||
               scene.shape.members_at[node.index].empty();
    };
    for (std::size_t i = 0; i < scene.model.nodes.size(); ++i)
        if (is_seen(femoop::NodeId{i})) draw_node_joint(scene, femoop::NodeId{i}, here);
}

} // namespace drawing
