#include "apps/drawing/truss/cremona_picture.h"

#include "apps/drawing/sheet/legend.h"
#include "apps/drawing/sketch/symbols.h"
#include "apps/drawing/structure/members.h"
#include "apps/drawing/truss/truss_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace drawing {

namespace {

using Eigen::Vector2d;
using femoop::MemberId;
using femoop::truss::ForceCause;
using femoop::truss::SpaceId;

/// Draws the diagram.
class ReciprocalDrawing {
public:
    ReciprocalDrawing(const Scene& scene, const TrussPicture& picture, const ui::Box& panel)
        : scene_(scene),
          picture_(picture),
          diagram_(*picture.diagram),
          panel_(panel),
          plan_(plan_of(diagram_, panel, scene.sketch.theme())),
          sides_(sides())
    {}

    void draw() const
    {
        draw_highlighted(scene_.state.selection, ui::Role::Selection);
        draw_highlighted(scene_.state.hover, ui::Role::Hover);
        light(diagram_.steps[picture_.n_stages - 1]);
        for (const ForceCause cause : {ForceCause::Reaction, ForceCause::Load}) draw_forces(cause);
        for (std::size_t i = 0; i < picture_.truss.bars.size(); ++i) {
            const double force = diagram_.joints.forces[i];
            if (!picture_.is_found(MemberId(i)) || force == 0.0) continue;
            const auto [a, b] = ends(MemberId(i));
            sketch().line(a, b, stroke_of(scene_, force));
        }
        draw_senses(diagram_.steps[picture_.n_stages - 1]);
        name_points();
    }

private:
    Sketch& sketch() const { return scene_.sketch; }
    ui::Point at(SpaceId space) const { return plan_(diagram_[space].point); }

    std::array<ui::Point, 2> ends(MemberId bar) const
    {
        const auto& [left, right] = diagram_.bar_spaces[bar.index];
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

    /// The sides of the joint's polygon that stand, and among them the line that is new; nothing while the pointer lights
    /// a bar.
    void light(const femoop::truss::DiagramStep& step) const
    {
        if (!scene_.state.hover.members.empty()) return;
        const ui::LayerScope layer(sketch().painter(), ui::Layer::Areas);
        for (const auto& [a, b] : standing_sides(step))
            sketch().line(a, b, highlight_stroke(scene_, ui::Role::Hover), Clearance::None);
        if (!step.bar) return;
        const ui::Stroke stroke = highlight_stroke(scene_, lit_role);
        if (step.is_open) return draw_open_line(step, stroke);
        const auto [a, b] = ends(*step.bar);
        sketch().line(a, b, stroke, Clearance::None);
    }

    /// How far it goes is not known yet, nor to which side.
    void draw_open_line(const femoop::truss::DiagramStep& step, const ui::Stroke& lit) const
    {
        const ui::Point from = at(*step.from);
        const Vector2d direction = picture_.truss[*step.bar].direction;
        const ui::Point along{direction.x(), -direction.y()};
        const ui::Point a = from - reach_to_rim(from, -1.0 * along) * along;
        const ui::Point b = from + reach_to_rim(from, along) * along;
        sketch().line(a, b, lit, Clearance::Soft);
        sketch().line(a, b, sketch().thin(ui::Role::Bar));
    }

    /// How far it is to the rim of the panel.
    double reach_to_rim(ui::Point from, ui::Point along) const
    {
        const ui::Box room = panel_.grown(-1.2 * sketch().theme().type().normal);
        const auto reach = [](double at, double way, double least, double most) {
            if (way == 0.0) return std::numeric_limits<double>::infinity();
            return std::max(((way > 0.0 ? most : least) - at) / way, 0.0);
        };
        return std::min(reach(from.x, along.x, room.min.x, room.max.x), reach(from.y, along.y, room.min.y, room.max.y));
    }

    std::vector<femoop::truss::PolygonSide> polygon_of(const femoop::truss::DiagramStep& step) const
    {
        if (!step.joint_step) return {};
        const femoop::truss::Step& found = diagram_.joints.steps[*step.joint_step];
        if (!found.joint) return {};
        std::vector<femoop::truss::PolygonSide> polygon = diagram_.polygon(picture_.truss, found);
        std::erase_if(polygon, [&](const auto& side) { return side.bar && !picture_.is_found(*side.bar); });
        return polygon;
    }

    std::vector<std::array<ui::Point, 2>> standing_sides(const femoop::truss::DiagramStep& step) const
    {
        std::vector<std::array<ui::Point, 2>> sides;
        for (const auto& side : polygon_of(step)) sides.push_back({at(side.from), at(side.to)});
        return sides;
    }

    /// An arrow head on each bar's side, as the bar acts on the joint: one after the other they go around.
    void draw_senses(const femoop::truss::DiagramStep& step) const
    {
        for (const auto& side : polygon_of(step)) {
            const ui::Point a = at(side.from), b = at(side.to);
            const double head = std::min(sketch().px(13.0), 0.6 * ui::distance(a, b));
            if (!side.bar || head <= 0.0) continue;
            const ui::Point along = ui::direction(b - a);
            const ui::Color color = stroke_of(scene_, diagram_.joints.forces[side.bar->index]).color;
            arrow_head(sketch(), 0.5 * (a + b) + 0.5 * head * along, along, head, color);
        }
    }

    void draw_forces(ForceCause cause) const
    {
        const ui::Role role = cause == ForceCause::Reaction ? ui::Role::Reaction : ui::Role::Load;
        const ui::Color color = sketch().theme().stroke(role).color;
        for (std::size_t i = 0; i < diagram_.forces.size(); ++i) {
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

    ForceCause cause_of(std::size_t i) const { return picture_.truss.forces[diagram_.forces[i]].cause; }

    std::array<ui::Point, 2> force_ends(std::size_t i) const
    {
        const auto spaces = diagram_.force_spaces(i);
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
        for (const femoop::truss::Space& space : diagram_.spaces) others += ui::dot(plan_(space.point) - a, across);
        return (others > 0.0 ? -1.0 : 1.0) * sketch().px(8.0) * across;
    }

    /// Of all loads and bars, drawn yet or not, so that nothing shifts from stage to stage.
    std::vector<std::array<ui::Point, 2>> sides() const
    {
        std::vector<std::array<ui::Point, 2>> all;
        for (std::size_t i = 0; i < diagram_.forces.size(); ++i)
            if (cause_of(i) == ForceCause::Load) all.push_back(force_ends(i));
        for (std::size_t i = 0; i < picture_.truss.bars.size(); ++i)
            if (diagram_.joints.forces[i] != 0.0) all.push_back(ends(MemberId(i)));
        return all;
    }

    /// Spaces whose points fall together share a name.
    void name_points() const
    {
        constexpr double together = 2.0; // [px]
        std::vector<bool> is_named(diagram_.spaces.size(), false);
        for (std::size_t i = 0; i < is_named.size(); ++i) {
            if (is_named[i] || !is_known(SpaceId(i))) continue;
            std::string name;
            for (std::size_t j = i; j < is_named.size(); ++j) {
                if (is_named[j] || !is_known(SpaceId(j)) || ui::distance(at(SpaceId(i)), at(SpaceId(j))) > together)
                    continue;
                is_named[j] = true;
                name += (name.empty() ? "" : ", ") + diagram_[SpaceId(j)].point_name();
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

    bool is_known(SpaceId space) const
    {
        return std::any_of(
            diagram_.steps.begin(), diagram_.steps.begin() + static_cast<std::ptrdiff_t>(picture_.n_stages),
            [&](const auto& step) { return std::ranges::find(step.spaces, space) != step.spaces.end(); });
    }

    const Scene& scene_;
    const TrussPicture& picture_;
    const femoop::truss::Reciprocal& diagram_;
    ui::Box panel_;
    DiagramPlan plan_;
    std::vector<std::array<ui::Point, 2>> sides_;
};

} // namespace

DiagramPlan plan_of(const femoop::truss::Reciprocal& diagram, const ui::Box& panel, const ui::Theme& theme)
{
    std::vector<Vector2d> points;
    for (const femoop::truss::Space& space : diagram.spaces) points.push_back(space.point);
    return DiagramPlan(points, panel, theme);
}

void draw_reciprocal(const Scene& scene, const TrussPicture& picture, const ui::Box& panel)
{
    ReciprocalDrawing(scene, picture, panel).draw();
}

PanelHead reciprocal_head(const Scene& scene, const TrussPicture& picture, const ui::Box& panel)
{
    return force_diagram_head(scene, scene.options.tr("Cremona diagram"),
                              plan_of(*picture.diagram, panel, scene.sketch.theme()).scale());
}

std::optional<MemberId> side_at(const TrussPicture& picture, const DiagramPlan& plan, ui::Point at, double reach)
{
    const femoop::truss::Reciprocal& diagram = *picture.diagram;
    std::optional<MemberId> nearest;
    for (std::size_t i = 0; i < picture.truss.bars.size(); ++i) {
        if (!picture.is_found(MemberId(i)) || diagram.joints.forces[i] == 0.0) continue;
        const auto& [left, right] = diagram.bar_spaces[i];
        const double off = distance_to_segment(at, plan(diagram[left].point), plan(diagram[right].point));
        if (off > reach) continue;
        reach = off;
        nearest = MemberId(i);
    }
    return nearest;
}

} // namespace drawing
