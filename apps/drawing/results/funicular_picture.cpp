#include "apps/drawing/results/funicular_picture.h"

#include <algorithm>
#include <cmath>

namespace drawing {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using femoop::funicular::Funicular;

constexpr ui::Role line_role = ui::Role::Reaction; // as a line of thrust

Vector3d in_plane(double x, double y) { return {x, y, 0.0}; }

/// Places along the curve, straight where no load is distributed.
std::vector<Vector3d> places_along(const Funicular& funicular)
{
    constexpr int parts_of_piece = 24;
    const int n = funicular.span.loads().stretches.empty() ? 1 : parts_of_piece;
    const std::vector<double> breaks = funicular.span.breaks();
    std::vector<Vector3d> places{in_plane(breaks.front(), funicular.height(breaks.front()))};
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
        for (int k = 1; k <= n; ++k) {
            const double x = std::lerp(breaks[i], breaks[i + 1], static_cast<double>(k) / n);
            places.push_back(in_plane(x, funicular.height(x)));
        }
    return places;
}

class FunicularDrawing {
public:
    FunicularDrawing(const Scene& scene, const FunicularPicture& picture)
        : scene_(scene), picture_(picture), funicular_(picture.funicular)
    {}

    void draw()
    {
        draw_closing_line();
        draw_polygon();
        draw_curve();
        draw_rise();
        if (picture_.reading) draw_reading(*picture_.reading);
        const ui::LayerScope layer(sketch().painter(), ui::Layer::Labels); // over supports
        for (const FunicularHandle handle : funicular_handles) draw_handle(handle);
    }

private:
    Sketch& sketch() const { return scene_.sketch; }
    ui::Point at(double x, double y) const { return scene_.projection(in_plane(x, y)); }

    ui::Stroke dashed(ui::Role role, ui::DashPattern dash) const
    {
        ui::Stroke stroke = sketch().thin(role);
        stroke.dash = dash;
        return stroke;
    }

    /// Dashed, and dotted from the ends of the chain to those that were dragged away.
    void draw_closing_line() const
    {
        const auto& [left, right] = funicular_.closing_line;
        const Vector2d &a = picture_.chain.left(), &b = picture_.chain.right();
        const ui::Stroke dots = dashed(ui::Role::Dimension, {1.5, 4.0});
        sketch().line(at(a.x(), a.y()), at(a.x(), left), dots, Clearance::Soft);
        sketch().line(at(b.x(), b.y()), at(b.x(), right), dots, Clearance::Soft);
        sketch().line(at(a.x(), left), at(b.x(), right), dashed(ui::Role::Dimension, {8.0, 4.0}), Clearance::Soft);
    }

    void draw_polygon() const
    {
        if (funicular_.span.loads().stretches.empty()) return; // the curve is the polygon
        std::vector<ui::Point> points;
        for (const Vector2d& corner : force_polygon(funicular_).corners(funicular_))
            points.push_back(at(corner.x(), corner.y()));
        ui::Stroke stroke = sketch().thin(line_role);
        stroke.width *= 0.5;
        sketch().polyline(points, stroke, Clearance::Soft);
    }

    void draw_curve() const
    {
        std::vector<ui::Point> points;
        for (const Vector3d& place : places_along(funicular_)) points.push_back(scene_.projection(place));
        sketch().polyline(points, sketch().stroke(line_role), Clearance::Soft);
    }

    void draw_rise() const
    {
        const double x = given_rise(funicular_, picture_.chain).x;
        if (picture_.reading && std::abs(*picture_.reading - x) < 1e-6 * funicular_.span.length()) return;
        draw_ordinate(x, "f = ");
    }

    void draw_ordinate(double x, const std::string& name) const
    {
        const ui::Point a = at(x, funicular_.closing(x)), b = at(x, funicular_.height(x));
        sketch().line(a, b, sketch().thin(ui::Role::Dimension), Clearance::Soft);
        if (!scene_.shows(Show::Values)) return;
        sketch().caption({.text = name + scene_.text(funicular_.ordinate(x), ui::Measure::Length),
                          .role = ui::Role::Dimension,
                          .target = 0.5 * (a + b),
                          .toward = {-1.0, 0.0},
                          .rank = Rank::Largest,
                          .others = {0.3 * a + 0.7 * b, 0.7 * a + 0.3 * b}});
    }

    void draw_reading(double x) const
    {
        draw_ordinate(x, "η = ");
        const double y = picture_.chain.height(x), e = funicular_.height(x) - y;
        const ui::Point axis = at(x, y), line = at(x, y + e);
        sketch().line(axis, line, sketch().stroke(ui::Role::BendingMoment), Clearance::Soft);
        sketch().disc(axis, sketch().px(2.5), sketch().theme()[ui::Role::BendingMoment].text, Clearance::Soft);
        if (!scene_.shows(Show::Values)) return;
        const double small = 1e-9 * scene_.shape.size;
        const double M = std::abs(e) <= small ? 0.0 : funicular_.H * e;
        sketch().caption({.text = "M = H e = " + scene_.text(M, ui::Measure::Moment),
                          .role = ui::Role::BendingMoment,
                          .target = 0.5 * (axis + line),
                          .toward = {1.0, 0.0},
                          .rank = Rank::Largest,
                          .others = {axis, line}});
    }

    /// A ring, filled where the hand can take hold of it.
    void draw_handle(FunicularHandle handle) const
    {
        const ui::Point center = scene_.projection(picture_.place_of(handle));
        const bool is_in_reach = picture_.in_reach == handle;
        const double radius = sketch().px(is_in_reach ? 6.5 : 5.0);
        const auto color = sketch().theme().stroke(line_role).color;
        sketch().disc(center, radius, is_in_reach ? color : sketch().theme().background());
        sketch().ring(center, radius, {.color = color, .width = sketch().px(2.0)});
    }

    const Scene& scene_;
    const FunicularPicture& picture_;
    const Funicular& funicular_;
};

} // namespace

Vector3d FunicularPicture::place_of(FunicularHandle handle) const
{
    const double x = funicular.span.largest_moment().x;
    switch (handle) {
    case FunicularHandle::LeftEnd: return in_plane(funicular.span.from(), funicular.closing_line.left);
    case FunicularHandle::RightEnd: return in_plane(funicular.span.to(), funicular.closing_line.right);
    case FunicularHandle::Rise: break;
    }
    return in_plane(x, funicular.height(x));
}

std::vector<Vector3d> places_of(const FunicularPicture& picture)
{
    std::vector<Vector3d> places = places_along(picture.funicular);
    for (const FunicularHandle handle : funicular_handles) places.push_back(picture.place_of(handle));
    return places;
}

void draw_funicular(const Scene& scene, const FunicularPicture& picture) { FunicularDrawing(scene, picture).draw(); }

PanelHead funicular_head(const Scene& scene, const FunicularPicture& picture)
{
    return {.name = scene.options.tr("Funicular"),
            .note = scene.options.tr("H = {H} · dashes: closing line",
                                     {{"H", scene.text(picture.funicular.H, ui::Measure::Force)}}),
            .role = line_role};
}

} // namespace drawing
