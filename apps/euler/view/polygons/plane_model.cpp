#include "apps/euler/view/polygons/plane_model.h"

#include "apps/euler/view/polygons/plane_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace euler {

using topology::HalfEdgeId;
using topology::LoopId;
using topology::Solid;

namespace {

using std::numbers::pi;
constexpr double beside_arrow = 11.0; // [px]
constexpr double line_gap = 4.0;      // [px] between a half-edge's line and the next one's
constexpr int n_of_arc = 48;

class PlaneModel {
public:
    PlaneModel(const PlaneLayout& layout, const PlaneOnItsWay& way, const ui::PlaneCamera& camera, double symbol_scale)
        : layout_(layout), way_(way), camera_(camera), symbol_scale_(symbol_scale)
    {
        shapes_.is_repeated = true;
    }

    void add(std::size_t subject, const PlaneLayout::Face& face)
    {
        shapes_.faces.push_back({subject, face.face, false});
        fill(subject, face);
        for (const LoopId l : face.loops) add_loop(subject, l);
    }
    Shapes take() { return std::move(shapes_); }

private:
    const Solid& solid(std::size_t subject) const { return layout_.solid(subject); }

    void fill(std::size_t subject, const PlaneLayout::Face& face)
    {
        Region area;
        if (solid(subject).is_lone(face.loops.front())) area.push_back(circle(face.outline));
        for (const LoopId l : face.loops)
            if (!solid(subject).is_lone(l)) area.push_back(rim(subject, l));
        shapes_.pieces.push_back({shapes_.faces.size() - 1, std::move(area), false});
    }

    std::vector<ui::Point> circle(const Polygon& outline) const
    {
        std::vector<ui::Point> points;
        for (int k = 0; k < outline.n_points(); ++k)
            points.push_back(camera_.to_sheet(outline.at(0, double{1.0} * k / outline.n_points())));
        return points;
    }

    std::vector<ui::Point> rim(std::size_t subject, LoopId l) const
    {
        std::vector<ui::Point> points;
        for (const HalfEdgeId h : solid(subject).chain(l)) {
            const std::vector<ui::Point> line = side(subject, h, 0.0, 0.0);
            points.insert(points.end(), line.begin(), line.end() - 1);
        }
        return points;
    }

    /// In the middle of its corners, which is the polygon's where it rests.
    ui::Point middle(std::size_t subject, LoopId l) const
    {
        if (way_.rests()) return camera_.to_sheet(layout_.polygon(subject, l).middle);
        ui::Point sum{};
        double n = 0.0;
        for (const HalfEdgeId h : solid(subject).chain(l)) {
            sum = sum + camera_.to_sheet(way_.at(subject, h, 0.0));
            n += 1.0;
        }
        return (1.0 / n) * sum;
    }

    void add_loop(std::size_t subject, LoopId l)
    {
        const std::size_t after = shapes_.pieces.size();
        const ui::Point middle = this->middle(subject, l);
        const bool is_lone = solid(subject).is_lone(l);
        for (const HalfEdgeId h : solid(subject).chain(l)) {
            const ui::Point at = camera_.to_sheet(way_.at(subject, h, 0.0)), outward = at - middle;
            const ui::Point toward = ui::length(outward) > 0.0 ? ui::direction(outward) : ui::Point{};
            shapes_.vertices.push_back({subject, solid(subject).start(h), at, false, after, toward});
            shapes_.arrows.push_back({subject, h, is_lone ? around(at) : arrow(subject, h), false, after});
            if (const auto e = solid(subject).edge(h))
                shapes_.edges.push_back({subject, *e, side(subject, h, 0.0, 0.0), false, after, e->index});
        }
    }

    /// So far inside the face, without `cut` of it at both ends.
    std::vector<ui::Point> side(std::size_t subject, HalfEdgeId h, double aside, double cut) const
    {
        std::vector<ui::Point> line;
        const int n = way_.n_points(subject, h);
        for (int k = 0; k <= n; ++k)
            line.push_back(camera_.to_sheet(way_.at(subject, h, cut + (1.0 - 2.0 * cut) * k / n, aside)));
        return line;
    }

    /// Inside the face: within an outer polygon, around a ring.
    std::vector<ui::Point> arrow(std::size_t subject, HalfEdgeId h) const
    {
        const Polygon& polygon = layout_.polygon(subject, solid(subject).loop(h));
        const double room = polygon.inner_radius() * camera_.scale();
        const double aside = std::min(beside_arrow * symbol_scale_, 0.35 * room) / room;
        const double length = 2.0 * pi * room / std::max(1, polygon.n);
        return side(subject, h, aside, std::min(0.2, (line_gap + 2.0) * symbol_scale_ / length));
    }

    std::vector<ui::Point> around(ui::Point middle) const
    {
        constexpr double radius = 18.0; // [px]
        std::vector<ui::Point> line;
        for (int k = 0; k <= n_of_arc; ++k) {
            const double angle = pi * (0.6 + 1.7 * k / n_of_arc);
            line.push_back(middle + radius * symbol_scale_ * ui::Point{std::cos(angle), -std::sin(angle)});
        }
        return line;
    }

    const PlaneLayout& layout_;
    const PlaneOnItsWay& way_;
    const ui::PlaneCamera& camera_;
    double symbol_scale_;
    Shapes shapes_;
};

} // namespace

Shapes plane_model(std::span<const Subject> subjects, const ui::PlaneCamera& camera, const Look& look,
                   const PlaneStep& step)
{
    const PlaneLayout layout(subjects), other(step.other);
    const PlaneOnItsWay way(layout, step.other.empty() ? nullptr : &other, step.share);
    PlaneModel model(layout, way, camera, look.full_theme().symbol_scale());
    for (std::size_t i = 0; i < subjects.size(); ++i)
        for (const PlaneLayout::Face& face : layout.faces(i)) model.add(i, face);
    return model.take();
}

ui::PlaneCamera fitted_plane_model(std::span<const Subject> subjects, ui::Size sheet, const PlaneStep& step)
{
    const auto corners = [](std::span<const Subject> of) {
        const ui::Box box = PlaneLayout(of).bounds();
        return std::array{box.min, box.max};
    };
    const bool rests = step.other.empty();
    const auto own = corners(subjects), there = rests ? own : corners(step.other);
    std::vector<ui::World2> mixed;
    for (std::size_t i = 0; i < own.size(); ++i) {
        const ui::Point p = rests ? own[i] : there[i] + step.share * (own[i] - there[i]);
        mixed.push_back({p.x, p.y});
    }
    ui::PlaneCamera camera;
    camera.fit(mixed, sheet);
    return camera;
}

} // namespace euler
