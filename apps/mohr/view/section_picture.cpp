#include "apps/mohr/view/section_picture.h"

#include <algorithm>
#include <cmath>

#include "apps/mohr/view/circle_picture.h"

namespace mohr {

namespace fm = femoop::mohr;
using ui::Role;

namespace {

/// Heights up the sheet, shared by the section and both diagrams.
struct Depth {
    ui::Painter& painter;
    const Scene& scene;
    ui::Theme theme;
    SectionMap map;

    const SectionState& section() const { return *scene.solution.section; }
    double height(double y) const { return map.middle - map.scale * y; }
};

std::vector<ui::Point> on_sheet(const Depth& d, const std::vector<femoop::OutlinePoint>& points, double middle)
{
    std::vector<ui::Point> line;
    for (const femoop::OutlinePoint& p : points) line.push_back({middle + d.map.scale * p.z, d.height(p.y)});
    return line;
}

void draw_outline(const Depth& d, double middle)
{
    const femoop::SectionOutline& outline = d.section().figure.outline();
    const double centre = middle - 0.5 * d.map.scale * (outline.left + outline.right);
    std::vector<std::vector<ui::Point>> loops{on_sheet(d, outline.outer, centre)};
    if (!outline.hole.empty()) loops.push_back(on_sheet(d, outline.hole, centre));
    d.painter.region(loops, d.theme.fill(Role::Support));
    for (const auto& loop : loops) d.painter.polyline(loop, d.theme.stroke(Role::Edge), ui::PathEnds::Closed);
}

/// One component over the depth, its value at the fibre written beside it.
struct ForceDiagram {
    double zero, reach; ///< where 0 lies, and pixels of the largest value
    double right;       ///< its room ends there
    double fm::FibreStress::*component;
    Role role;
    std::string name;
};

void draw_diagram(const Depth& d, const ForceDiagram& diagram)
{
    double largest = 0.0;
    for (const fm::FibreStress& s : d.section().distribution)
        largest = std::max(largest, std::abs(s.*diagram.component));
    const double scale = largest > 0.0 ? diagram.reach / largest : 0.0;
    std::vector<ui::Point> line;
    for (const fm::FibreStress& s : d.section().distribution)
        line.push_back({diagram.zero + scale * s.*diagram.component, d.height(s.cut.y)});
    std::vector<ui::Point> area = line;
    area.push_back({diagram.zero, line.back().y});
    area.insert(area.begin(), {diagram.zero, line.front().y});
    d.painter.polygon(area, d.theme.fill(diagram.role));
    d.painter.polyline(line, d.theme.stroke(diagram.role));
    d.painter.line({diagram.zero, line.front().y}, {diagram.zero, line.back().y}, d.theme.stroke(Role::Label));
    const double value = d.section().fibre.*diagram.component;
    const ui::Point at{diagram.zero + scale * value, d.height(d.section().fibre.cut.y)};
    draw_mark(d.painter, d.scene, at, std::nullopt, diagram.role);
    ui::TextStyle style = d.theme.text(diagram.role, ui::Anchor::BottomLeft);
    style.plate = d.theme.background();
    const ui::LayerScope layer(d.painter, ui::Layer::Labels);
    const std::string words = diagram.name + " = " + d.scene.look.number(value) + " MPa";
    const double left = std::min(diagram.zero + diagram.reach + 14.0,
                                 diagram.right - d.painter.measure(words, style).width);
    d.painter.text({left, at.y - 4.0}, words, style);
}

/// Across everything, at the height of the fibre.
void draw_fibre(const Depth& d, const ui::Box& box, Drawn& drawn)
{
    const double y = d.height(d.section().fibre.cut.y);
    d.painter.line({box.min.x, y}, {box.max.x, y}, d.theme.stroke(Role::LocalAxes));
    const ui::Point at{box.min.x + 8.0 * d.theme.symbol_scale(), y};
    draw_mark(d.painter, d.scene, at, Handle::Fibre, Role::LocalAxes);
    drawn.places.push_back({Handle::Fibre, at});
    ui::TextStyle style = d.theme.text(Role::LocalAxes, ui::Anchor::BottomLeft);
    style.plate = d.theme.background();
    const ui::LayerScope layer(d.painter, ui::Layer::Labels);
    d.painter.text(at + ui::Point{0.7 * style.size, -4.0},
                   "y′ = " + d.scene.look.number(d.section().fibre.cut.y) + " mm", style);
}

} // namespace

void draw_section(ui::Painter& painter, const Scene& scene, const ui::Box& box, Drawn& drawn)
{
    const fm::SectionFigure& figure = scene.solution.section->figure;
    const double depth = figure.top() - figure.bottom(), third = box.width() / 3.0;
    const double scale = std::min(0.9 * box.height() / depth, 0.5 * third / std::max(figure.outline().width(), 1e-9));
    drawn.section = {box.center().y + 0.5 * scale * (figure.top() + figure.bottom()), scale};
    const Depth d{painter, scene, scene.look.full_theme(), drawn.section};
    draw_outline(d, box.min.x + 0.7 * third); // the fibre's height is written at its left
    const double middle = box.min.x + 2.0 * third - 4.0;
    draw_diagram(d,
                 {box.min.x + 1.36 * third, 0.24 * third, middle, &fm::FibreStress::sigma, Role::BendingMoment, "σ"});
    draw_diagram(d, {box.min.x + 2.24 * third, 0.24 * third, box.max.x, &fm::FibreStress::tau, Role::ShearForce, "τ"});
    draw_fibre(d, box, drawn);
}

} // namespace mohr
