#include "apps/drawing/truss/cremona_picture.h"

#include "apps/drawing/loads/forces.h"
#include "apps/drawing/sheet/legend.h"
#include "apps/drawing/structure/members.h"
#include "apps/drawing/structure/supports.h"
#include "femoop/io/truss/truss_sentence.h"

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

constexpr ui::Role letter_role = ui::Role::LocalAxes; // of the spaces and of their points

Vector3d in_space(const Vector2d& v) { return {v.x(), v.y(), 0.0}; }

/// Hue and dashes both tell the sense.
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

double distance_to(ui::Point at, ui::Point a, ui::Point b)
{
    const ui::Point along = b - a;
    const double share = std::clamp(ui::dot(at - a, along) / std::max(ui::dot(along, along), 1e-12), 0.0, 1.0);
    return ui::distance(at, a + share * along);
}

/// Draws the truss and names its spaces.
class TrussDrawing {
public:
    TrussDrawing(const Scene& scene, const CremonaPicture& picture) : scene_(scene), picture_(picture) {}

    void draw() const
    {
        for (std::size_t i = 0; i < picture_.truss.bars.size(); ++i) draw_bar(MemberId(i));
        if (picture_.n_stages > 0)
            for (std::size_t i = 0; i < picture_.diagram.forces.size(); ++i) draw_force_at(i);
        for (std::size_t i = 0; i < picture_.diagram.spaces.size(); ++i) name_space(SpaceId(i));
    }

private:
    Sketch& sketch() const { return scene_.sketch; }
    ui::Point place(femoop::NodeId joint) const { return scene_.place(joint); }

    void draw_bar(MemberId bar) const
    {
        const auto& joints = picture_.truss[bar].joints;
        const ui::Point a = place(joints[0]), b = place(joints[1]);
        const double force = picture_.diagram.joints.forces[bar.index];
        if (!picture_.is_found(bar)) return sketch().line(a, b, sketch().thin(ui::Role::Bar));
        sketch().line(a, b, stroke_of(scene_, force));
        if (!scene_.shows(Show::Values)) return;
        const std::string sense = force == 0.0 ? "" : force > 0.0 ? " (T)" : " (C)";
        const ui::Point across = ui::left_normal(ui::direction(b - a));
        sketch().caption({.text = scene_.number(std::abs(force), ui::Measure::Force) + sense,
                          .role = force > 0.0   ? ui::Role::BendingMoment
                                  : force < 0.0 ? ui::Role::Load
                                                : ui::Role::FaintLabel,
                          .target = 0.5 * (a + b),
                          .toward = across.y > 0.0 ? -across : across,
                          .gap = 4.0,
                          .rank = Rank::Value,
                          .size = sketch().lesser_value_size(),
                          .others = {0.4 * a + 0.6 * b, 0.6 * a + 0.4 * b, 0.3 * a + 0.7 * b, 0.7 * a + 0.3 * b},
                          .reach = 30.0,
                          .along = ui::direction(b - a)});
    }

    const femoop::truss::Spoke& spoke_of(std::size_t force) const
    {
        const auto& spokes = picture_.diagram.arrangement[picture_.truss.forces[force].joint.index];
        return *std::ranges::find(spokes, std::optional(force), &femoop::truss::Spoke::force);
    }

    void draw_force_at(std::size_t i) const
    {
        const std::size_t number = picture_.diagram.forces[i];
        const femoop::truss::ExternalForce& force = picture_.truss.forces[number];
        const Vector2d direction = force.force.normalized(), away = spoke_of(number).away;
        const bool is_reaction = force.cause == ForceCause::Reaction;
        drawing::draw_force(scene_, {.at = in_space(picture_.truss.joints[force.joint.index]),
                                     .direction = in_space(direction),
                                     .length = arrow_length(),
                                     .touches = direction.dot(away) > 0.0 ? ArrowAt::Tail : ArrowAt::Head,
                                     .gap = gap_of(number),
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
        const femoop::truss::Space& space = picture_.diagram[id];
        if (space.is_inside) return name_inside(space);
        if (picture_.n_stages == 0) return;
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
        const ui::LayerScope layer(sketch().painter(), ui::Layer::Labels);
        ui::TextStyle style = sketch().theme().text(letter_role, ui::Anchor::Center);
        style.weight = ui::Weight::Bold;
        style.size = std::clamp(fitting * room, 0.8 * sketch().theme().type().small, letter_size());
        sketch().painter().text(at, space.name, style);
        const ui::Size size = ui::label_size(sketch().painter().fonts(), space.name, style);
        sketch().reserve(ui::box_at(at - ui::Point{0.5 * size.width, 0.5 * size.height}, size));
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
            room = std::min(room, distance_to(at, a, b));
            if ((a.y > at.y) != (b.y > at.y) && at.x < a.x + (b.x - a.x) * (at.y - a.y) / (b.y - a.y))
                is_inside = !is_inside;
        }
        return is_inside ? room : 0.0;
    }

    /// Outside, half way between the two forces that bound it.
    ui::Point beside(SpaceId id) const
    {
        const femoop::truss::Space& space = picture_.diagram[id];
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
        const std::size_t n = picture_.diagram.n_outside();
        const std::size_t before = picture_.diagram.forces[(id.index + n - 1) % n],
                          after = picture_.diagram.forces[id.index];
        const Vector2d sum = spoke_of(before).away + spoke_of(after).away;
        const Vector2d across(-spoke_of(after).away.y(), spoke_of(after).away.x());
        Vector2d away = across;
        if (sum.norm() > 0.2) away = sum.normalized();
        return place(picture_.truss.forces[after].joint) + off * scene_.projection.direction(in_space(away));
    }

    ui::Point begin(const femoop::truss::Way& way) const { return place(begin_of(picture_.truss, way)); }
    ui::Point end(const femoop::truss::Way& way) const { return place(end_of(picture_.truss, way)); }

    const Scene& scene_;
    const CremonaPicture& picture_;
};

/// Draws the diagram.
class ReciprocalDrawing {
public:
    ReciprocalDrawing(const Scene& scene, const CremonaPicture& picture, const ui::Box& panel)
        : scene_(scene),
          picture_(picture),
          plan_(plan_of(picture.diagram, panel, scene.sketch.theme())),
          sides_(sides())
    {}

    void draw() const
    {
        draw_highlighted(scene_.state.selection, ui::Role::Selection);
        draw_highlighted(scene_.state.hover, ui::Role::Hover);
        if (picture_.n_stages > 0)
            for (const ForceCause cause : {ForceCause::Reaction, ForceCause::Load}) draw_forces(cause);
        for (std::size_t i = 0; i < picture_.truss.bars.size(); ++i) {
            const double force = picture_.diagram.joints.forces[i];
            if (!picture_.is_found(MemberId(i)) || force == 0.0) continue;
            const auto [a, b] = ends(MemberId(i));
            sketch().line(a, b, stroke_of(scene_, force));
        }
        name_points();
    }

private:
    Sketch& sketch() const { return scene_.sketch; }
    ui::Point at(SpaceId space) const { return plan_(picture_.diagram[space].point); }

    std::array<ui::Point, 2> ends(MemberId bar) const
    {
        const auto& [left, right] = picture_.diagram.bar_spaces[bar.index];
        return {at(left), at(right)};
    }

    void draw_highlighted(const Highlight& highlight, ui::Role role) const
    {
        const ui::LayerScope layer(sketch().painter(), ui::Layer::Areas);
        for (const MemberId bar : highlight.members) {
            if (bar.index >= picture_.truss.bars.size() || !picture_.is_found(bar)) continue;
            const auto [a, b] = ends(bar);
            sketch().line(a, b, highlight_stroke(scene_, role), Clearance::None);
        }
    }

    void draw_forces(ForceCause cause) const
    {
        const ui::Role role = cause == ForceCause::Reaction ? ui::Role::Reaction : ui::Role::Load;
        const ui::Color color = sketch().theme().stroke(role).color;
        for (std::size_t i = 0; i < picture_.diagram.forces.size(); ++i) {
            if (cause_of(i) != cause) continue;
            const auto [begin, end] = force_ends(i);
            const ui::Point along = ui::direction(end - begin);
            const ui::Point aside = cause == ForceCause::Reaction ? beside_sides(begin, end) : ui::Point{};
            const ui::Point a = begin + aside, b = end + aside;
            sketch().line(a, b, {.color = color, .width = sketch().px(2.4)});
            const double head = std::min(sketch().px(11.0), 0.6 * ui::distance(a, b));
            arrow_head(sketch(), 0.5 * (a + b) + 0.5 * head * along, along, head, color);
        }
    }

    ForceCause cause_of(std::size_t i) const { return picture_.truss.forces[picture_.diagram.forces[i]].cause; }

    std::array<ui::Point, 2> force_ends(std::size_t i) const
    {
        const auto spaces = picture_.diagram.force_spaces(i);
        return {at(spaces[0]), at(spaces[1])};
    }

    /// A reaction on the line of a load or of a bar's side is drawn beside it, away from the other sides.
    ui::Point beside_sides(ui::Point a, ui::Point b) const
    {
        constexpr double same_line = 1.0; // [px]
        const ui::Point across = ui::left_normal(ui::direction(b - a));
        const auto is_below = [&](const std::array<ui::Point, 2>& side) {
            return std::ranges::all_of(side,
                                       [&](ui::Point end) { return std::abs(ui::dot(end - a, across)) < same_line; });
        };
        if (std::ranges::none_of(sides_, is_below)) return {};
        double others = 0.0;
        for (const femoop::truss::Space& space : picture_.diagram.spaces)
            others += ui::dot(plan_(space.point) - a, across);
        return (others > 0.0 ? -1.0 : 1.0) * sketch().px(8.0) * across;
    }

    /// Of all loads and bars, drawn yet or not, so that nothing shifts from stage to stage.
    std::vector<std::array<ui::Point, 2>> sides() const
    {
        std::vector<std::array<ui::Point, 2>> all;
        for (std::size_t i = 0; i < picture_.diagram.forces.size(); ++i)
            if (cause_of(i) == ForceCause::Load) all.push_back(force_ends(i));
        for (std::size_t i = 0; i < picture_.truss.bars.size(); ++i)
            if (picture_.diagram.joints.forces[i] != 0.0) all.push_back(ends(MemberId(i)));
        return all;
    }

    /// Spaces whose points fall together share a name.
    void name_points() const
    {
        constexpr double together = 2.0; // [px]
        std::vector<bool> is_named(picture_.diagram.spaces.size(), false);
        for (std::size_t i = 0; i < is_named.size(); ++i) {
            if (is_named[i] || !picture_.is_known(SpaceId(i))) continue;
            std::string name;
            for (std::size_t j = i; j < is_named.size(); ++j) {
                if (is_named[j] || !picture_.is_known(SpaceId(j)) ||
                    ui::distance(at(SpaceId(i)), at(SpaceId(j))) > together)
                    continue;
                is_named[j] = true;
                name += (name.empty() ? "" : ", ") + picture_.diagram[SpaceId(j)].point_name();
            }
            name_point(at(SpaceId(i)), name);
        }
    }

    void name_point(ui::Point at, const std::string& name) const
    {
        const ui::LayerScope layer(sketch().painter(), ui::Layer::Symbols);
        sketch().disc(at, sketch().px(2.8), sketch().theme()[letter_role].text);
        sketch().caption({.text = name,
                          .role = letter_role,
                          .target = at,
                          .toward = {at.x < plan_(Vector2d::Zero()).x - 1.0 ? -1.0 : 1.0, -0.3},
                          .gap = sketch().px(6.0),
                          .rank = Rank::Largest,
                          .weight = ui::Weight::Bold,
                          .size = 1.15 * sketch().theme().type().normal,
                          .reach = 60.0});
    }

    const Scene& scene_;
    const CremonaPicture& picture_;
    DiagramPlan plan_;
    std::vector<std::array<ui::Point, 2>> sides_;
};

} // namespace

bool CremonaPicture::is_found(MemberId bar) const
{
    return std::any_of(diagram.steps.begin(), diagram.steps.begin() + static_cast<std::ptrdiff_t>(n_stages),
                       [&](const auto& step) { return std::ranges::find(step.bars, bar) != step.bars.end(); });
}

bool CremonaPicture::is_known(SpaceId space) const
{
    return std::any_of(diagram.steps.begin(), diagram.steps.begin() + static_cast<std::ptrdiff_t>(n_stages),
                       [&](const auto& step) { return std::ranges::find(step.spaces, space) != step.spaces.end(); });
}

CremonaPicture cremona_picture(const femoop::Model& model, const femoop::truss::Truss& truss, const ui::Catalogue& tr)
{
    CremonaPicture picture{.truss = truss, .diagram = femoop::truss::reciprocal(truss)};
    picture.n_stages = picture.diagram.steps.size();
    for (std::size_t i = 0; i < picture.n_stages; ++i)
        picture.sentences.push_back(std::to_string(i + 1) + "/" + std::to_string(picture.n_stages) + "  " +
                                    sentence(picture.diagram.steps[i], truss, picture.diagram, model, tr));
    return picture;
}

void draw_truss(const Scene& scene, const CremonaPicture& picture) { TrussDrawing(scene, picture).draw(); }

PanelHead truss_head(const Scene& scene)
{
    const ui::Catalogue& tr = scene.options.tr;
    return {.name = tr("Truss with Bow's notation"),
            .note = tr("full line: tension (T) · dashes: compression (C) · dots: no force")};
}

DiagramPlan plan_of(const femoop::truss::Reciprocal& diagram, const ui::Box& panel, const ui::Theme& theme)
{
    std::vector<Vector2d> points;
    for (const femoop::truss::Space& space : diagram.spaces) points.push_back(space.point);
    return DiagramPlan(points, panel, theme);
}

void draw_reciprocal(const Scene& scene, const CremonaPicture& picture, const ui::Box& panel)
{
    ReciprocalDrawing(scene, picture, panel).draw();
}

PanelHead reciprocal_head(const Scene& scene, const CremonaPicture& picture, const ui::Box& panel)
{
    return force_diagram_head(scene, scene.options.tr("Cremona diagram"),
                              plan_of(picture.diagram, panel, scene.sketch.theme()).scale());
}

std::optional<MemberId> side_at(const CremonaPicture& picture, const DiagramPlan& plan, ui::Point at, double reach)
{
    std::optional<MemberId> nearest;
    for (std::size_t i = 0; i < picture.truss.bars.size(); ++i) {
        if (!picture.is_found(MemberId(i)) || picture.diagram.joints.forces[i] == 0.0) continue;
        const auto& [left, right] = picture.diagram.bar_spaces[i];
        const double off = distance_to(at, plan(picture.diagram[left].point), plan(picture.diagram[right].point));
        if (off > reach) continue;
        reach = off;
        nearest = MemberId(i);
    }
    return nearest;
}

} // namespace drawing
