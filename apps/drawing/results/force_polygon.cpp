#include "apps/drawing/geometry/diagram_plan.h"
#include "apps/drawing/results/funicular_picture.h"
#include "apps/drawing/sheet/legend.h"
#include "apps/drawing/sketch/symbols.h"

#include <algorithm>
#include <cmath>

namespace drawing {

namespace {

using Eigen::Vector2d;
using femoop::funicular::ForcePolygon;

constexpr ui::Role ray_role = ui::Role::Reaction; // of sides of the funicular

/// Beside the load line, away from the pole, is room for the reactions.
DiagramPlan polygon_plan(const ForcePolygon& polygon, ui::Box panel, const ui::Theme& theme)
{
    const double room = 5.0 * theme.type().normal;
    if (polygon.pole.x() < 0.0) panel.max.x -= room;
    else panel.min.x += room;
    std::vector<Vector2d> points{polygon.pole, {0.0, polygon.closing_level}};
    for (const double level : polygon.levels) points.emplace_back(0.0, level);
    return DiagramPlan(points, panel, theme);
}

class ForcePolygonDrawing {
public:
    ForcePolygonDrawing(const Scene& scene, const FunicularPicture& picture, const ui::Box& panel)
        : scene_(scene),
          picture_(picture),
          polygon_(force_polygon(picture.funicular)),
          plan_(polygon_plan(polygon_, panel, scene.sketch.theme()))
    {}

    void draw() const
    {
        draw_rays();
        for (std::size_t i = 0; i < polygon_.loads.size(); ++i)
            draw_force(polygon_.levels[i], polygon_.levels[i + 1], {ui::Role::Load, 0.0, {}});
        draw_reaction(polygon_.levels.back(), polygon_.closing_level, picture_.chain.nodes.back());
        draw_reaction(polygon_.closing_level, 0.0, picture_.chain.nodes.front());
        draw_thrust();
        draw_pole();
    }

private:
    Sketch& sketch() const { return scene_.sketch; }
    ui::Point on_line(double level) const { return plan_({0.0, level}); }
    /// Away from the pole.
    double outward() const { return polygon_.pole.x() < 0.0 ? 1.0 : -1.0; }

    void draw_rays() const
    {
        const ui::Point pole = plan_(polygon_.pole);
        for (const double level : polygon_.levels)
            sketch().line(pole, on_line(level), sketch().thin(ray_role), Clearance::Soft);
        ui::Stroke closing = sketch().thin(ui::Role::Dimension);
        closing.dash = {8.0, 4.0};
        sketch().line(pole, on_line(polygon_.closing_level), closing, Clearance::Soft);
    }

    struct Look {
        ui::Role role;
        double aside; ///< [px] from the load line
        std::string name;
    };

    void draw_force(double from, double to, const Look& look) const
    {
        const ui::Point aside{outward() * look.aside, 0.0};
        const ui::Point a = on_line(from) + aside, b = on_line(to) + aside;
        const ui::Color color = sketch().theme().stroke(look.role).color;
        sketch().line(a, b, {.color = color, .width = sketch().px(2.4)});
        const double head = std::min(sketch().px(10.0), 0.6 * ui::distance(a, b));
        const ui::Point along = ui::direction(b - a);
        arrow_head(sketch(), 0.5 * (a + b) + 0.5 * head * along, along, head, color);
        sketch().disc(b, sketch().px(1.8), color, Clearance::None);
        if (!scene_.shows(Show::Values) || head <= 0.0) return;
        sketch().caption({.text = look.name + scene_.number(std::abs(to - from), ui::Measure::Force),
                          .role = look.role,
                          .target = 0.5 * (a + b),
                          .toward = {outward(), 0.0},
                          .gap = sketch().px(6.0),
                          .rank = look.name.empty() ? Rank::Value : Rank::Largest,
                          .size = sketch().lesser_value_size(),
                          .reach = 40.0});
    }

    /// Beside the loads, in the sense in which it closes the polygon.
    void draw_reaction(double from, double to, femoop::NodeId node) const
    {
        if (from == to) return;
        draw_force(from, to, {ui::Role::Reaction, 3.4 * sketch().theme().type().normal, scene_.model[node].id + ": "});
    }

    /// Below all.
    void draw_thrust() const
    {
        const double lowest = std::min({polygon_.levels.back(), polygon_.pole.y(), polygon_.closing_level, 0.0});
        const double y = on_line(lowest).y + sketch().px(16.0), tick = sketch().px(4.0);
        const ui::Point a{plan_(polygon_.pole).x, y}, b{on_line(0.0).x, y};
        const ui::Stroke stroke = sketch().thin(ui::Role::Dimension);
        sketch().line(a, b, stroke);
        for (const ui::Point end : {a, b})
            sketch().line(end - ui::Point{0.0, tick}, end + ui::Point{0.0, tick}, stroke);
        sketch().caption({.text = "H = " + scene_.number(picture_.funicular.H, ui::Measure::Force),
                          .role = ui::Role::Dimension,
                          .target = 0.5 * (a + b),
                          .toward = {0.0, 1.0},
                          .rank = Rank::Largest});
    }

    void draw_pole() const
    {
        const ui::LayerScope layer(sketch().painter(), ui::Layer::Symbols);
        const ui::Point pole = plan_(polygon_.pole);
        sketch().disc(pole, sketch().px(3.2), sketch().theme()[ui::Role::Label].text);
        sketch().caption({.text = "O",
                          .role = ui::Role::Label,
                          .target = pole,
                          .toward = {-outward(), -0.3},
                          .gap = sketch().px(6.0),
                          .rank = Rank::Largest,
                          .weight = ui::Weight::Bold});
    }

    const Scene& scene_;
    const FunicularPicture& picture_;
    ForcePolygon polygon_;
    DiagramPlan plan_;
};

} // namespace

void draw_force_polygon(const Scene& scene, const FunicularPicture& picture, const ui::Box& panel)
{
    ForcePolygonDrawing(scene, picture, panel).draw();
}

PanelHead force_polygon_head(const Scene& scene, const FunicularPicture& picture, const ui::Box& panel)
{
    const ForcePolygon polygon = force_polygon(picture.funicular);
    return force_diagram_head(scene, scene.options.tr("Force polygon"),
                              polygon_plan(polygon, panel, scene.sketch.theme()).scale());
}

} // namespace drawing
