#include "apps/drawing/results/free_body_picture.h"

#include "apps/drawing/loads/forces.h"
#include "femoop/result/components.h"

#include <algorithm>
#include <cmath>

namespace drawing {

namespace {

using Eigen::Vector3d;
using namespace femoop::free_body;
using femoop::MemberComponent;

constexpr double negligible = 1e-9; // of the largest on the body

ui::Role role_of(ForceKind kind)
{
    switch (kind) {
    case ForceKind::NodeLoad:
    case ForceKind::MemberLoad: return ui::Role::Load;
    case ForceKind::Reaction:
    case ForceKind::Foundation: return ui::Role::Reaction;
    case ForceKind::SectionForces: break;
    }
    return ui::Role::ShearForce;
}

/// Draws one body, its forces as far as they are more than rounding.
class BodyPainter {
public:
    BodyPainter(const Scene& scene, const FreeBodyPicture& picture) : scene_(scene), picture_(picture)
    {
        for (const Force& force : picture.lifted.forces) {
            const double moment = force.moment.cwiseAbs().maxCoeff() / scene.shape.size;
            largest_ = std::max({largest_, force.force.cwiseAbs().maxCoeff(), moment});
        }
    }

    void draw()
    {
        for (const Piece& piece : picture_.lifted.body.pieces) draw_piece(piece);
        const ui::LayerScope layer(scene_.sketch.painter(), ui::Layer::Symbols);
        for (const femoop::NodeId node : picture_.lifted.body.nodes) draw_node(node);
        for (const Force& force : picture_.lifted.forces) draw_force(force);
        if (picture_.ritter) draw_lines_to(picture_.lifted.ritter_points[*picture_.ritter]);
        for (const RitterPoint& point : picture_.lifted.ritter_points) draw_ritter_point(point);
        draw_moment_point();
    }

private:
    void draw_piece(const Piece& piece)
    {
        const MemberShape& member = scene_.shape[piece.member];
        scene_.sketch.line(at(member.at(piece.from)), at(member.at(piece.to)), scene_.sketch.stroke(ui::Role::Member));
    }

    void draw_node(femoop::NodeId node)
    {
        const ui::Point place = at(scene_.shape[node]);
        scene_.sketch.disc(place, scene_.sketch.px(4.0), scene_.sketch.theme().fill(ui::Role::Node));
        scene_.sketch.caption({.text = scene_.model[node].id,
                               .role = ui::Role::Label,
                               .target = place,
                               .toward = {-0.7, 0.7},
                               .gap = scene_.sketch.px(7.0),
                               .rank = Rank::Name,
                               .weight = ui::Weight::Bold});
    }

    /// Section forces in the member's own axes, by the names that diagrams have.
    void draw_force(Force force)
    {
        if (force.kind == ForceKind::SectionForces) draw_stub(force);
        for (const ForceComponent& one : components(force))
            if (one.is_moment) draw_couple(force, one.direction, one.value, one.of);
            else draw_component(force, one.direction, one.value, one.of);
    }

    void draw_component(const Force& force, const Vector3d& axis, double value,
                        std::optional<MemberComponent> component)
    {
        if (std::abs(value) <= negligible * largest_) return;
        const Vector3d direction = value < 0.0 ? Vector3d(-axis) : axis;
        const ArrowAt touches = touching_end(force, direction);
        drawing::draw_force(
            scene_, {.at = force.at + picture_.aside,
                     .direction = direction,
                     .length = scene_.sketch.px(38.0),
                     .touches = touches,
                     .gap = scene_.sketch.px(5.0),
                     .text = named(component, scene_.text(std::abs(value), ui::Measure::Force)) +
                             (component == MemberComponent::N ? sense(value) : ""),
                     .role = role_of(force.kind),
                     .text_side = side_of_slanting(touches == ArrowAt::Head ? Vector3d(-direction) : direction)});
    }

    /// Beyond the end of an arrow that slants its value would stand far off: above or below it.
    std::optional<ui::Point> side_of_slanting(const Vector3d& away) const
    {
        constexpr double straight = 0.3;
        const ui::Point d = scene_.projection.direction(away);
        if (std::abs(d.x) < straight || std::abs(d.y) < straight) return std::nullopt;
        return ui::Point{std::copysign(straight, d.x), std::copysign(1.0, d.y)};
    }

    void draw_couple(const Force& force, const Vector3d& axis, double value, std::optional<MemberComponent> component)
    {
        if (std::abs(value) <= negligible * largest_ * scene_.shape.size) return;
        draw_moment(scene_,
                    {.at = force.at + picture_.aside,
                     .axis = value < 0.0 ? Vector3d(-axis) : axis,
                     .text = named(component, scene_.text(std::abs(value), ui::Measure::Moment)),
                     .role = force.kind == ForceKind::SectionForces ? ui::Role::BendingMoment : role_of(force.kind),
                     .radius = 20.0});
    }

    /// A member that is cut off at a node keeps a stub there, so that its forces stand apart from those of the others,
    /// unless it has an axial force alone.
    void draw_stub(Force& section)
    {
        const double near = 1e-6 * scene_.shape.size;
        const auto is_here = [&](const Vector3d& place) { return (place - section.at).norm() < near; };
        const Body& body = picture_.lifted.body;
        const bool is_at_node = std::ranges::any_of(body.nodes,
                                                    [&](femoop::NodeId node) { return is_here(scene_.shape[node]); });
        const bool has_piece = std::ranges::any_of(body.pieces,
                                                   [&](const Piece& piece) { return piece.member == *section.member; });
        const femoop::SectionForces& s = section.section;
        const bool is_bar = std::hypot(s.Vy, s.Vz) <= negligible * largest_ &&
                            std::hypot(s.T, s.My, s.Mz) <= negligible * largest_ * scene_.shape.size;
        if (!is_at_node || has_piece || is_bar) return;
        const Vector3d face = section.at + scene_.sketch.px(84.0) / scene_.projection.scale() * outward(section);
        scene_.sketch.line(at(section.at), at(face), scene_.sketch.stroke(ui::Role::Member));
        section.at = face;
    }

    Vector3d outward(const Force& section) const
    {
        return (section.is_on_plus_face ? 1.0 : -1.0) * scene_.shape[*section.member].x();
    }

    /// Does a member that was cut off at that place go this way?
    bool has_cut_toward(const Vector3d& place, const Vector3d& way) const
    {
        constexpr double alike = 0.9;
        return std::ranges::any_of(picture_.lifted.forces, [&](const Force& other) {
            return other.kind == ForceKind::SectionForces && (other.at - place).norm() < 1e-6 * scene_.shape.size &&
                   outward(other).dot(way) > alike;
        });
    }

    /// Section forces lie outside of the body, before its face; others come to it with their heads, or where a section
    /// has its forces there go on beyond it.
    ArrowAt touching_end(const Force& force, const Vector3d& direction) const
    {
        if (force.kind == ForceKind::SectionForces)
            return direction.dot(outward(force)) < -0.5 ? ArrowAt::Head : ArrowAt::Tail;
        const bool goes_beyond = has_cut_toward(force.at, -direction) && !has_cut_toward(force.at, direction);
        return goes_beyond ? ArrowAt::Tail : ArrowAt::Head;
    }

    /// The arrow has the sign; of an axial force the letter says it too, as along the bars of a truss.
    static std::string sense(double N) { return N < 0.0 ? " (C)" : " (T)"; }

    std::string named(std::optional<MemberComponent> component, const std::string& value) const
    {
        if (!component) return value;
        return std::string(femoop::name(*component, scene_.model.analysis)) + " = " + value;
    }

    /// From the other cuts to where their bars meet.
    void draw_lines_to(const RitterPoint& point)
    {
        ui::Stroke stroke = scene_.sketch.thin(ui::Role::Dimension);
        stroke.dash = {4.0, 3.0};
        for (const Vector3d& cut : point.others) scene_.sketch.line(at(cut), at(point.at), stroke, Clearance::Soft);
    }

    void draw_ritter_point(const RitterPoint& point)
    {
        const ui::Point place = at(point.at);
        const double r = scene_.sketch.px(4.0);
        const ui::Stroke stroke = scene_.sketch.thin(ui::Role::Dimension);
        scene_.sketch.line(place - ui::Point{r, r}, place + ui::Point{r, r}, stroke, Clearance::Soft);
        scene_.sketch.line(place - ui::Point{r, -r}, place + ui::Point{r, -r}, stroke, Clearance::Soft);
        scene_.sketch.caption({.text = scene_.options.tr("for {bar}", {{"bar", scene_.model[point.bar].id}}),
                               .role = ui::Role::Dimension,
                               .target = place,
                               .toward = {0.7, -0.7},
                               .gap = scene_.sketch.px(9.0),
                               .rank = Rank::Name});
    }

    void draw_moment_point()
    {
        const ui::Point place = at(picture_.about);
        const double r = scene_.sketch.px(7.0);
        const ui::Stroke stroke = scene_.sketch.thin(ui::Role::Dimension);
        scene_.sketch.ring(place, r, stroke, Clearance::Soft);
        scene_.sketch.line(place - ui::Point{1.6 * r, 0.0}, place + ui::Point{1.6 * r, 0.0}, stroke, Clearance::Soft);
        scene_.sketch.line(place - ui::Point{0.0, 1.6 * r}, place + ui::Point{0.0, 1.6 * r}, stroke, Clearance::Soft);
    }

    ui::Point at(const Vector3d& place) const { return scene_.projection(place + picture_.aside); }

    const Scene& scene_;
    const FreeBodyPicture& picture_;
    double largest_ = 0.0;
};

} // namespace

std::vector<Vector3d> places_of(const FreeBodyPicture& picture, const StructureShape& shape)
{
    std::vector<Vector3d> places{picture.moment_point()};
    for (const RitterPoint& point : picture.lifted.ritter_points) {
        const Vector3d place = point.at + picture.aside;
        const double off = (place - picture.moment_point()).norm();
        if (off <= shape.size) places.push_back(place); // of nearly parallel bars one lies anywhere
    }
    for (const femoop::NodeId node : picture.lifted.body.nodes) places.push_back(shape[node] + picture.aside);
    for (const Piece& piece : picture.lifted.body.pieces)
        for (const double x : {piece.from, piece.to}) places.push_back(shape[piece.member].at(x) + picture.aside);
    return places;
}

void draw_free_body(const Scene& scene, const FreeBodyPicture& picture) { BodyPainter(scene, picture).draw(); }

} // namespace drawing
