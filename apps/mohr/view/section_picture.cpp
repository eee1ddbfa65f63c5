#include "apps/mohr/view/section_picture.h"

#include <algorithm>
#include <array>
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
    bool has_broken_captions; ///< a name and its value have no room beside one another

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

struct Caption {
    std::string name, value;
    Role role;
};
std::string in_one_line(const Caption& caption) { return caption.name + " = " + caption.value; }

constexpr double line_height = 1.3; ///< of its size

/// Below the picture that it belongs to: a text on the picture would cover what lies behind.
void draw_caption(const Depth& d, const ui::Box& column, const Caption& caption)
{
    const ui::TextStyle style = d.theme.text(caption.role, ui::Anchor::BottomLeft);
    const ui::LayerScope layer(d.painter, ui::Layer::Labels);
    const auto line = [&](const std::string& words, double up) {
        const double most = column.width() - 0.6 * style.size, width = d.painter.measure(words, style).width;
        ui::TextStyle fitting = style;
        fitting.size *= std::min(1.0, most / width);
        const double shown = std::min(width, most);
        d.painter.text({column.min.x + 0.5 * (column.width() - shown), column.max.y - up}, words, fitting);
    };
    if (d.has_broken_captions) {
        line(caption.name + " =", line_height * style.size);
        line(caption.value, 0.0);
    } else line(in_one_line(caption), 0.0);
}

/// One component over the depth, its value at the fibre written below.
struct ForceDiagram {
    double fm::FibreStress::*component;
    Caption caption;
};

void draw_diagram(const Depth& d, const ui::Box& column, const ForceDiagram& diagram)
{
    double largest = 0.0;
    for (const fm::FibreStress& s : d.section().distribution)
        largest = std::max(largest, std::abs(s.*diagram.component));
    const double zero = column.center().x, reach = 0.3 * column.width();
    const double scale = largest > 0.0 ? reach / largest : 0.0;
    std::vector<ui::Point> line;
    for (const fm::FibreStress& s : d.section().distribution)
        line.push_back({zero + scale * s.*diagram.component, d.height(s.cut.y)});
    std::vector<ui::Point> area = line;
    area.push_back({zero, line.back().y});
    area.insert(area.begin(), {zero, line.front().y});
    d.painter.polygon(area, d.theme.fill(diagram.caption.role));
    d.painter.polyline(line, d.theme.stroke(diagram.caption.role));
    d.painter.line({zero, line.front().y}, {zero, line.back().y}, d.theme.stroke(Role::Label));
    const double value = d.section().fibre.*diagram.component;
    draw_mark(d.painter, d.scene, {zero + scale * value, d.height(d.section().fibre.cut.y)}, std::nullopt,
              diagram.caption.role);
    draw_caption(d, column, diagram.caption);
}

/// Across everything, at its height.
void draw_fibre(const Depth& d, const ui::Box& box, Drawn& drawn)
{
    const double y = d.height(d.section().fibre.cut.y);
    d.painter.line({box.min.x, y}, {box.max.x, y}, d.theme.stroke(Role::LocalAxes));
    const ui::Point at{box.min.x + 8.0 * d.theme.symbol_scale(), y};
    draw_mark(d.painter, d.scene, at, Handle::Fibre, Role::LocalAxes);
    drawn.places.push_back({Handle::Fibre, at});
}

} // namespace

void draw_section(ui::Painter& painter, const Scene& scene, const ui::Box& box, Drawn& drawn)
{
    const fm::SectionFigure& figure = scene.solution.section->figure;
    const fm::FibreStress& fibre = scene.solution.section->fibre;
    const ui::Theme theme = scene.look.full_theme();
    const ui::TextStyle style = theme.text(Role::Label, ui::Anchor::BottomLeft);
    const double third = box.width() / 3.0;
    const std::array captions{Caption{"y′", scene.look.number(fibre.cut.y) + " mm", Role::LocalAxes},
                              Caption{"σ", scene.look.number(fibre.sigma) + " MPa", Role::BendingMoment},
                              Caption{"τ", scene.look.number(fibre.tau) + " MPa", Role::ShearForce}};
    const bool is_broken = std::ranges::any_of(captions, [&](const Caption& c) {
        return painter.measure(in_one_line(c), style).width + 0.3 * style.size > third;
    });
    const double caption = (1.5 + (is_broken ? line_height : 0.0)) * style.size;
    const double depth = figure.top() - figure.bottom();
    const double height = 0.95 * (box.height() - caption);
    const double scale = std::min(height / depth, 0.5 * third / std::max(figure.outline().width(), 1e-9));
    const double middle = box.center().y - 0.5 * caption;
    drawn.section = {middle + 0.5 * scale * (figure.top() + figure.bottom()), scale};
    const Depth d{painter, scene, theme, drawn.section, is_broken};
    const auto column = [&](double i) {
        return ui::Box{{box.min.x + i * third, box.min.y}, {box.min.x + (i + 1.0) * third, box.max.y}};
    };
    draw_outline(d, column(0.0).center().x);
    draw_caption(d, column(0.0), captions[0]);
    draw_diagram(d, column(1.0), {&fm::FibreStress::sigma, captions[1]});
    draw_diagram(d, column(2.0), {&fm::FibreStress::tau, captions[2]});
    draw_fibre(d, box, drawn);
}

} // namespace mohr
