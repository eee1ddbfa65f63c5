#include "apps/drawing/truss/truss_drawing.h"

#include "apps/drawing/loads/forces.h"
#include "apps/drawing/structure/members.h"
#include "apps/drawing/structure/supports.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace drawing {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using femoop::MemberId;
using femoop::truss::ForceCause;
using femoop::truss::SpaceId;

constexpr double ems_of_force = 8.0; // "101.3 (C)", and what stands about it
constexpr std::string_view senses = ui::translatable(
    "full line: tension (T) · dashes: compression (C) · dots: no force");

Vector3d in_space(const Vector2d& v) { return {v.x(), v.y(), 0.0}; }

/// Draws the truss and names its spaces.
class TrussDrawing {
public:
    TrussDrawing(const Scene& scene, const TrussPicture& picture) : scene_(scene), picture_(picture) {}

    void draw() const
    {
        light(picture_.stage());
        for (std::size_t i = 0; i < picture_.truss.bars.size(); ++i) draw_bar(MemberId(i));
        for (std::size_t i = 0; i < picture_.truss.forces.size(); ++i) draw_force_at(i);
        if (!picture_.diagram) return;
        for (std::size_t i = 0; i < picture_.diagram->spaces.size(); ++i) name_space(SpaceId(i));
    }

private:
    Sketch& sketch() const { return scene_.sketch; }
    ui::Point place(femoop::NodeId joint) const { return scene_.place(joint); }

    /// The joint and the bars that the stage is about; of a section its Ritter point too.
    void light(const TrussStage& stage) const
    {
        const ui::LayerScope layer(sketch().painter(), ui::Layer::Areas);
        const ui::Stroke stroke = highlight_stroke(scene_, lit_role);
        for (const MemberId bar : stage.lit) {
            const auto& joints = picture_.truss[bar].joints;
            sketch().line(place(joints[0]), place(joints[1]), stroke, Clearance::None);
        }
        if (stage.joint) sketch().disc(place(*stage.joint), sketch().px(11.0), stroke.color, Clearance::None);
        if (stage.ritter_point) {
            const ui::Stroke cross = sketch().stroke(lit_role);
            const ui::Point at = scene_.projection(in_space(*stage.ritter_point)), arm{sketch().px(7.0), 0.0};
            sketch().ring(at, arm.x, cross);
            sketch().line(at - arm, at + arm, cross);
            sketch().line(at - ui::left_normal(arm), at + ui::left_normal(arm), cross);
        }
    }

    void draw_bar(MemberId bar) const
    {
        const auto& joints = picture_.truss[bar].joints;
        const ui::Point a = place(joints[0]), b = place(joints[1]);
        const double force = picture_.joints.forces[bar.index];
        if (!picture_.is_found(bar)) return sketch().line(a, b, sketch().thin(ui::Role::Bar));
        sketch().line(a, b, stroke_of(scene_, force));
        if (!scene_.shows(Show::Values)) return;
        const std::string sense = force == 0.0 || is_short(ui::distance(a, b)) ? "" : force > 0.0 ? " (T)" : " (C)";
        const ui::Point across = ui::left_normal(ui::direction(b - a));
        sketch().caption({.text = scene_.number(std::abs(force), ui::Measure::Force) + sense,
                          .role = role_of(force),
                          .target = 0.5 * (a + b),
                          .toward = across.y > 0.0 ? -across : across,
                          .gap = 4.0,
                          .rank = Rank::Value,
                          .size = value_size(ui::distance(a, b)),
                          .others = {0.4 * a + 0.6 * b, 0.6 * a + 0.4 * b, 0.3 * a + 0.7 * b, 0.7 * a + 0.3 * b},
                          .reach = 30.0,
                          .along = ui::direction(b - a)});
    }

    /// Where bars are short the sense is left to line and hue.
    bool is_short(double length) const { return length < ems_of_force * sketch().lesser_value_size(); }

    /// Em of a value beside a bar so long.
    double value_size(double length) const
    {
        constexpr double ems = 5.0; // of a number, with what is left free beside it
        const double most = sketch().lesser_value_size();
        if (!is_short(length)) return most;
        const double small = std::min(most, sketch().theme().type().small);
        return std::clamp(length / ems, std::min(small, ui::TypeSizes().normal), small);
    }

    const femoop::truss::Spoke& spoke_of(std::size_t force) const
    {
        const auto& spokes = picture_.arrangement[picture_.truss.forces[force].joint.index];
        return *std::ranges::find(spokes, std::optional(force), &femoop::truss::Spoke::force);
    }

    void draw_force_at(std::size_t i) const
    {
        const femoop::truss::ExternalForce& force = picture_.truss.forces[i];
        const Vector2d direction = force.force.normalized(), away = spoke_of(i).away;
        const bool is_reaction = force.cause == ForceCause::Reaction;
        drawing::draw_force(scene_, {.at = in_space(picture_.truss.joints[force.joint.index]),
                                     .direction = in_space(direction),
                                     .length = arrow_length(),
                                     .touches = direction.dot(away) > 0.0 ? ArrowAt::Tail : ArrowAt::Head,
                                     .gap = gap_of(i),
                                     .text = scene_.number(force.force.norm(), ui::Measure::Force),
                                     .role = is_reaction ? ui::Role::Reaction : ui::Role::Load});
    }

    double arrow_length() const { return sketch().px(34.0); }

    /// Behind the symbol of the support, and behind another force that comes from the same side.
    double gap_of(std::size_t number) const
    {
        const femoop::truss::ExternalForce& force = picture_.truss.forces[number];
        const Vector2d away = spoke_of(number).away;
        constexpr double same_side = 0.8; // cosine
        double gap = 0.0;
        if (const auto side = support_side(scene_, force.joint)) {
            const ui::Point ray = scene_.projection.direction(in_space(away));
            if (ui::dot(ray, *side) > same_side) gap = support_reach(sketch());
        }
        for (std::size_t other = 0; other < number; ++other)
            if (picture_.truss.forces[other].joint == force.joint && spoke_of(other).away.dot(away) > same_side)
                gap += arrow_length() + sketch().px(14.0);
        return gap;
    }

    void name_space(SpaceId id) const
    {
        const femoop::truss::Space& space = (*picture_.diagram)[id];
        if (space.is_inside) return name_inside(space);
        sketch().caption({.text = space.name,
                          .role = letter_role,
                          .target = beside(id),
                          .toward = {0.0, 0.0},
                          .gap = 0.0,
                          .rank = Rank::Largest,
                          .weight = ui::Weight::Bold,
                          .size = letter_size(),
                          .reach = 60.0});
    }

    double letter_size() const { return 1.25 * sketch().theme().type().normal; }

    /// Beside its space a name would be another's: it stays within, if need be smaller.
    void name_inside(const femoop::truss::Space& space) const
    {
        constexpr double fitting = 1.7; // em of a circle's radius
        const auto [at, room] = middle_of(space);
        const double least = 0.8 * sketch().theme().type().small;
        if (fitting * room < least) return name_where_free(space, at, least);
        const ui::LayerScope layer(sketch().painter(), ui::Layer::Labels);
        ui::TextStyle style = sketch().theme().text(letter_role, ui::Anchor::Center);
        style.weight = ui::Weight::Bold;
        const double most = std::clamp(0.6 * room, std::min(ui::TypeSizes().large, letter_size()), letter_size());
        style.size = std::clamp(fitting * room, least, most); // forces need room too
        sketch().painter().text(at, space.name, style);
        const ui::Size size = ui::label_size(sketch().painter().fonts(), space.name, style);
        sketch().reserve(ui::box_at(at - ui::Point{0.5 * size.width, 0.5 * size.height}, size));
    }

    /// There, or counted among the labels without room.
    void name_where_free(const femoop::truss::Space& space, ui::Point at, double size) const
    {
        sketch().caption({.text = space.name,
                          .role = letter_role,
                          .target = at,
                          .toward = {0.0, 0.0},
                          .gap = 0.0,
                          .rank = Rank::Largest,
                          .weight = ui::Weight::Bold,
                          .size = size,
                          .reach = 0.0});
    }

    struct Middle {
        ui::Point at;
        double room = 0.0; ///< distance from the nearest bar
    };

    /// Where within its bars there is most room.
    Middle middle_of(const femoop::truss::Space& space) const
    {
        std::vector<ui::Point> corners;
        for (const femoop::truss::Way& way : space.outline) corners.push_back(place(begin_of(picture_.truss, way)));
        ui::Box box{corners.front(), corners.front()};
        for (const ui::Point corner : corners) box = ui::united(box, {corner, corner});
        constexpr int n = 24;
        Middle best{box.center()};
        for (int i = 1; i < n; ++i)
            for (int j = 1; j < n; ++j) {
                const ui::Point at{box.min.x + box.width() * i / n, box.min.y + box.height() * j / n};
                const double room = room_at(at, corners);
                if (room > 1.001 * best.room) best = {at, room};
            }
        return best;
    }

    /// Distance from the nearest side; 0 outside.
    static double room_at(ui::Point at, const std::vector<ui::Point>& corners)
    {
        bool is_inside = false;
        double room = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const ui::Point a = corners[i], b = corners[(i + 1) % corners.size()];
            room = std::min(room, distance_to_segment(at, a, b));
            if ((a.y > at.y) != (b.y > at.y) && at.x < a.x + (b.x - a.x) * (at.y - a.y) / (b.y - a.y))
                is_inside = !is_inside;
        }
        return is_inside ? room : 0.0;
    }

    /// Outside, half way between the two forces that bound it.
    ui::Point beside(SpaceId id) const
    {
        const femoop::truss::Space& space = (*picture_.diagram)[id];
        const double off = sketch().px(30.0);
        double length = 0.0;
        for (const femoop::truss::Way& way : space.outline) length += ui::distance(begin(way), end(way));
        if (length == 0.0) return between_forces(id, sketch().px(46.0));
        double left = 0.5 * length;
        for (const femoop::truss::Way& way : space.outline) {
            const double own = ui::distance(begin(way), end(way));
            if (left > own) {
                left -= own;
                continue;
            }
            const ui::Point along = ui::direction(end(way) - begin(way));
            return begin(way) + left * along + off * ui::left_normal(along);
        }
        return between_forces(id, off);
    }

    /// Both forces act at one joint: between their lines.
    ui::Point between_forces(SpaceId id, double off) const
    {
        const std::size_t n = picture_.diagram->n_outside();
        const std::size_t before = picture_.diagram->forces[(id.index + n - 1) % n],
                          after = picture_.diagram->forces[id.index];
        const Vector2d sum = spoke_of(before).away + spoke_of(after).away;
        const Vector2d across(-spoke_of(after).away.y(), spoke_of(after).away.x());
        Vector2d away = across;
        if (sum.norm() > 0.2) away = sum.normalized();
        return place(picture_.truss.forces[after].joint) + off * scene_.projection.direction(in_space(away));
    }

    ui::Point begin(const femoop::truss::Way& way) const { return place(begin_of(picture_.truss, way)); }
    ui::Point end(const femoop::truss::Way& way) const { return place(end_of(picture_.truss, way)); }

    const Scene& scene_;
    const TrussPicture& picture_;
};

} // namespace

ui::Stroke stroke_of(const Scene& scene, double force)
{
    const ui::Theme& theme = scene.sketch.theme();
    const double width = scene.sketch.stroke(ui::Role::Bar).width;
    if (force == 0.0) return {.color = theme[ui::Role::FaintLabel].text, .width = width, .dash = {1.5, 4.0}};
    const ui::Role role = force > 0.0 ? ui::Role::BendingMoment : ui::Role::Load;
    ui::Stroke stroke{.color = theme.stroke(role).color, .width = 1.4 * width};
    if (force < 0.0) stroke.dash = {9.0, 4.0};
    return stroke;
}

ui::Role role_of(double force)
{
    if (force == 0.0) return ui::Role::FaintLabel;
    return force > 0.0 ? ui::Role::BendingMoment : ui::Role::Load;
}

double distance_to_segment(ui::Point at, ui::Point a, ui::Point b)
{
    const ui::Point along = b - a;
    const double share = std::clamp(ui::dot(at - a, along) / std::max(ui::dot(along, along), 1e-12), 0.0, 1.0);
    return ui::distance(at, a + share * along);
}

void draw_truss(const Scene& scene, const TrussPicture& picture) { TrussDrawing(scene, picture).draw(); }

PanelHead truss_head(const Scene& scene, const TrussPicture& picture)
{
    const ui::Catalogue& tr = scene.options.tr;
    switch (picture.method) {
    case TrussMethod::ZeroForces: return {.name = tr("Zero-force bars"), .note = tr("dots and 0: no force")};
    case TrussMethod::Joints: return {.name = tr("Truss joint by joint"), .note = tr(senses)};
    case TrussMethod::Cremona: break;
    }
    return {.name = tr("Truss with Bow's notation"), .note = tr(senses)};
}

} // namespace drawing
