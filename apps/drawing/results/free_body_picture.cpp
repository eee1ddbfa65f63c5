#include "apps/drawing/results/free_body_picture.h"

#include "apps/drawing/loads/forces.h"
#include "apps/drawing/structure/members.h"
#include "femoop/result/components.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace drawing {

namespace {

using Eigen::Vector3d;
using namespace femoop::free_body;
using femoop::MemberComponent;

constexpr double negligible = 1e-9; // of the largest on the body

constexpr double arrow_length = 38.0, arrow_gap = 5.0; // [px] of the arrow of a force, and to it

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
        for (const Arrow& arrow : arrows()) draw_arrow(arrow);
        for (const femoop::NodeId node : picture_.lifted.body.nodes) draw_node(node);
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
        for (const femoop::MemberId member : scene_.shape.members_at[node.index])
            for (const std::size_t end : {0U, 1U})
                if (scene_.model[member].nodes.at(end) == node && is_end_drawn(member, end))
                    draw_end_joint(scene_, member, end, picture_.aside);
        draw_node_joint(scene_, node, picture_.aside);
        scene_.sketch.caption({.text = scene_.model[node].id,
                               .role = ui::Role::Label,
                               .target = place,
                               .toward = {-0.7, 0.7},
                               .gap = scene_.sketch.px(7.0),
                               .rank = Rank::Name,
                               .weight = ui::Weight::Bold});
    }

    /// A component of a force, of section forces in the member's own axes, by the names that diagrams have.
    struct Arrow {
        Force force; ///< where it is drawn: beyond the stub of its member
        ForceComponent one;
    };

    /// In the order in which their values choose where to stand: those of the sections before all else, which the picture
    /// is drawn for; then in the plane those that are small beside others of their kind last, in space, where more meet, the
    /// larger the sooner.
    std::vector<Arrow> arrows()
    {
        constexpr double minor = 0.1;
        std::vector<Arrow> list;
        for (Force force : picture_.lifted.forces) {
            if (force.kind == ForceKind::SectionForces) draw_stub(force);
            for (const ForceComponent& one : components(force)) list.push_back({force, one});
        }
        double largest_force = 0.0, largest_moment = 0.0;
        for (const auto& [force, one] : list) {
            double& largest = one.is_moment ? largest_moment : largest_force;
            largest = std::max(largest, std::abs(one.value));
        }
        std::ranges::stable_sort(list, {}, [&](const Arrow& arrow) {
            const double largest = arrow.one.is_moment ? largest_moment : largest_force;
            const double share = largest > 0.0 ? std::abs(arrow.one.value) / largest : 0.0;
            const double turn = scene_.is_flat() ? (share < minor ? 1.0 : 0.0) : -share;
            return std::pair(arrow.force.kind != ForceKind::SectionForces, turn);
        });
        return list;
    }

    void draw_arrow(const Arrow& arrow)
    {
        const auto& [force, one] = arrow;
        if (one.is_moment) draw_couple(force, one.direction, one.value, one.of);
        else draw_component(force, one.direction, one.value, one.of);
    }

    void draw_component(const Force& force, const Vector3d& axis, double value,
                        std::optional<MemberComponent> component)
    {
        if (std::abs(value) <= negligible * largest_) return;
        const Vector3d direction = value < 0.0 ? Vector3d(-axis) : axis;
        const ArrowAt touches = touching_end(force, direction);
        const Vector3d away = touches == ArrowAt::Head ? Vector3d(-direction) : direction;
        const std::string text = named(component, force, scene_.text(std::abs(value), ui::Measure::Force)) +
                                 (component == MemberComponent::N ? sense(value) : "");
        const auto side = side_off_its_like(force, away);
        drawing::draw_force(scene_, {.at = force.at + beside_others(force, direction, away) + picture_.aside,
                                     .direction = direction,
                                     .length = scene_.sketch.px(arrow_length),
                                     .touches = touches,
                                     .gap = scene_.sketch.px(arrow_gap),
                                     .text = side ? std::string() : text,
                                     .role = role_of(force.kind),
                                     .text_side = text_side(force, away)});
        if (side && scene_.shows(Show::Values)) write_beside_arrow(force, away, *side, text);
    }

    void write_beside_arrow(const Force& force, const Vector3d& away, ui::Point side, const std::string& text)
    {
        const ui::Point way = scene_.projection.direction(away);
        scene_.sketch.caption({.text = text,
                               .role = role_of(force.kind),
                               .target = at(force.at) + scene_.sketch.px(arrow_gap + 0.6 * arrow_length) * way,
                               .toward = side,
                               .gap = scene_.sketch.px(7.0),
                               .rank = Rank::Largest,
                               .of = at(force.at)});
    }

    /// How far off its place a load or a reaction is drawn: beside a member that leaves it no other side, and beside those
    /// that have come to stand on this side of its place before.
    Vector3d beside_others(const Force& force, const Vector3d& direction, const Vector3d& away)
    {
        constexpr double apart = 9.0, alike = 0.99; // [px], the cosine
        if (force.kind == ForceKind::SectionForces) return Vector3d::Zero();
        const auto n_there = std::ranges::count_if(standing_, [&](const Standing& other) {
            return is_near(other.at, force.at) && other.away.dot(away) > alike;
        });
        standing_.push_back({force.at, away});
        const bool has_member = is_taken(force.at, away) && is_taken(force.at, -away);
        const auto n = static_cast<double>(n_there + (has_member ? 1 : 0));
        return n * scene_.sketch.px(apart) / scene_.projection.scale() *
               scene_.projection.toward_eye().cross(direction).normalized();
    }

    /// Of an arrow across a stub beyond its section, so that it stands off the members beside.
    std::optional<ui::Point> text_side(const Force& force, const Vector3d& away) const
    {
        const auto slanting = side_of_slanting(away);
        if (slanting || force.kind != ForceKind::SectionForces || has_piece(*force.member)) return slanting;
        const ui::Point across = scene_.projection.direction(away), out = scene_.projection.direction(outward(force));
        if (std::abs(dot(across, out)) > 0.5) return std::nullopt;
        return across + out;
    }

    /// Along a bar beside another one that goes much the same way: on the far side from that one.
    std::optional<ui::Point> side_off_its_like(const Force& force, const Vector3d& away) const
    {
        if (force.kind != ForceKind::SectionForces || std::abs(away.dot(outward(force))) < 0.5) return std::nullopt;
        const Force* const other = its_like(force);
        if (other == nullptr) return std::nullopt;
        const ui::Point across = ui::left_normal(scene_.projection.direction(away));
        const ui::Point to_other = scene_.projection(other->at) - scene_.projection(force.at);
        return dot(to_other, across) > 0.0 ? -across : across;
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
                     .text = named(component, force, scene_.text(std::abs(value), ui::Measure::Moment)),
                     .role = force.kind == ForceKind::SectionForces ? ui::Role::BendingMoment : role_of(force.kind),
                     .radius = 20.0});
    }

    /// A member that is cut off at a node keeps a stub there, so that its forces stand apart from those of the others,
    /// unless it has an axial force alone.
    void draw_stub(Force& section)
    {
        if (!has_stub(section)) return;
        const Vector3d face = section.at + scene_.sketch.px(84.0) / scene_.projection.scale() * outward(section);
        scene_.sketch.line(at(section.at), at(face), scene_.sketch.stroke(ui::Role::Member));
        section.at = face;
    }

    bool has_stub(const Force& section) const
    {
        const Body& body = picture_.lifted.body;
        const bool is_at_node = std::ranges::any_of(
            body.nodes, [&](femoop::NodeId node) { return is_near(scene_.shape[node], section.at); });
        const femoop::SectionForces& s = section.section;
        const bool is_bar = std::hypot(s.Vy, s.Vz) <= negligible * largest_ &&
                            std::hypot(s.T, s.My, s.Mz) <= negligible * largest_ * scene_.shape.size;
        return is_at_node && !has_piece(*section.member) && !is_bar;
    }
    bool has_piece(femoop::MemberId member) const
    {
        return std::ranges::any_of(picture_.lifted.body.pieces,
                                   [&](const Piece& piece) { return piece.member == member; });
    }

    /// Is a part of the member drawn there, a piece of it or a stub?
    bool is_end_drawn(femoop::MemberId member, std::size_t end) const
    {
        const MemberShape& shape = scene_.shape[member];
        const Vector3d& place = end == 0 ? shape.start : shape.end;
        const bool is_in_body = std::ranges::any_of(picture_.lifted.body.pieces, [&](const Piece& piece) {
            return piece.member == member && is_near(shape.at(end == 0 ? piece.from : piece.to), place);
        });
        return is_in_body || std::ranges::any_of(picture_.lifted.forces, [&](const Force& force) {
                   return force.kind == ForceKind::SectionForces && force.member == member &&
                          is_near(force.at, place) && has_stub(force);
               });
    }

    double near() const { return 1e-6 * scene_.shape.size; }
    bool is_near(const Vector3d& a, const Vector3d& b) const { return (a - b).norm() < near(); }

    Vector3d outward(const Force& section) const
    {
        return (section.is_on_plus_face ? 1.0 : -1.0) * scene_.shape[*section.member].x();
    }

    /// Does a member that was cut off at that place go this way?
    bool has_cut_toward(const Vector3d& place, const Vector3d& way) const
    {
        constexpr double alike = 0.9;
        return std::ranges::any_of(picture_.lifted.forces, [&](const Force& other) {
            return other.kind == ForceKind::SectionForces && is_near(other.at, place) &&
                   outward(other).dot(way) > alike;
        });
    }

    /// Section forces lie outside of the body, before its face; others come to it with their heads, or where a section
    /// has its forces there go on beyond it.
    ArrowAt touching_end(const Force& force, const Vector3d& direction) const
    {
        if (force.kind == ForceKind::SectionForces)
            return direction.dot(outward(force)) < -0.5 ? ArrowAt::Head : ArrowAt::Tail;
        const bool goes_beyond = is_taken(force.at, -direction) && !is_taken(force.at, direction);
        return goes_beyond ? ArrowAt::Tail : ArrowAt::Head;
    }

    /// Does a part of the body, or a section's force, go this way from that place?
    bool is_taken(const Vector3d& place, const Vector3d& way) const
    {
        return has_cut_toward(place, way) || std::ranges::any_of(picture_.lifted.body.pieces, [&](const Piece& piece) {
                   return goes_toward(piece, place, way);
               });
    }
    bool goes_toward(const Piece& piece, const Vector3d& place, const Vector3d& way) const
    {
        constexpr double alike = 0.9;
        const MemberShape& member = scene_.shape[piece.member];
        const double x = member.x().dot(place - member.start), along = member.x().dot(way);
        return is_near(member.at(x), place) && ((along > alike && x > piece.from - near() && x < piece.to - near()) ||
                                                (along < -alike && x < piece.to + near() && x > piece.from + near()));
    }

    /// The arrow has the sign; of an axial force the letter says it too, as along the bars of a truss.
    static std::string sense(double N) { return N < 0.0 ? " (C)" : " (T)"; }

    /// "N = 12 kN"; "N(AB) = 12 kN" where bars are cut near by each other that go much the same way, and in space where
    /// more members than one are cut.
    std::string named(std::optional<MemberComponent> component, const Force& force, const std::string& value) const
    {
        if (!component) return value;
        const bool has_likes = std::ranges::any_of(picture_.lifted.forces,
                                                   [&](const Force& one) { return its_like(one) != nullptr; });
        const bool is_told_apart = has_likes || (!scene_.is_flat() && has_other_cuts(force));
        const std::string bar = is_told_apart ? "(" + scene_.model[*force.member].id + ")" : "";
        return std::string(femoop::name(*component, scene_.model.analysis)) + bar + " = " + value;
    }
    /// Null where there is none.
    const Force* its_like(const Force& force) const
    {
        constexpr double alike = 0.7, near_by = 110.0; // [px], of arrows and labels
        if (force.kind != ForceKind::SectionForces) return nullptr;
        const double reach = scene_.sketch.px(near_by) / scene_.projection.scale();
        const auto found = std::ranges::find_if(picture_.lifted.forces, [&](const Force& other) {
            return other.kind == ForceKind::SectionForces && other.member != force.member &&
                   (other.at - force.at).norm() <= reach && outward(other).dot(outward(force)) > alike;
        });
        return found != picture_.lifted.forces.end() ? &*found : nullptr;
    }
    bool has_other_cuts(const Force& force) const
    {
        return std::ranges::any_of(picture_.lifted.forces, [&](const Force& other) {
            return other.kind == ForceKind::SectionForces && other.member != force.member;
        });
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
    /// Where loads and reactions have been drawn, and on which side of their place.
    struct Standing {
        Vector3d at, away;
    };
    std::vector<Standing> standing_;
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
