#include "apps/drawing/structure/drawn_dimensions.h"

#include "apps/drawing/structure/dimension_symbol.h"
#include "apps/drawing/structure/members.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace drawing {

namespace {

using Eigen::Vector2d;

bool is_drawn_in(const femoop::Model& model) { return femoop::n_coordinates(model.analysis) == 2; }

class DrawnDimension {
public:
    DrawnDimension(const Scene& scene, const DimensionLine& line, const DimensionLayout& layout)
        : scene_(scene), layout_(layout)
    {
        const Vector2d side = line.offset < 0.0 ? Vector2d(-layout.left()) : layout.left();
        outward_ = ui::direction(scene.projection.direction({side.x(), side.y(), 0.0}));
    }

    void highlight(ui::Role role) const
    {
        const ui::LayerScope layer(scene_.sketch.painter(), ui::Layer::Areas);
        scene_.sketch.line(start(), end(), highlight_stroke(scene_, role), Clearance::None);
    }

    void draw_leaders() const
    {
        for (const DimensionLayout::Mark& mark : layout_.marks)
            if (!is_behind_another(mark)) draw_leader(at(mark.node), at(mark.foot));
    }

    void draw_lengths() const
    {
        for (std::size_t i = 1; i < layout_.marks.size(); ++i) {
            const DimensionLayout::Mark &a = layout_.marks[i - 1], &b = layout_.marks[i];
            const double length = b.level - a.level;
            if (length <= nothing * scene_.shape.size) continue;
            draw(scene_, {.start = at(a.foot), .end = at(b.foot), .outward = outward_, .length = length});
        }
    }

    ui::Point start() const { return at(layout_.marks.front().foot); }
    ui::Point end() const { return at(layout_.marks.back().foot); }

private:
    static constexpr double nothing = 1e-9; // of the structure's size: nodes at one level

    ui::Point at(const Vector2d& place) const { return scene_.projection({place.x(), place.y(), 0.0}); }

    // A nearer node leads to the same place already, on the same side.
    bool is_behind_another(const DimensionLayout::Mark& mark) const
    {
        const Vector2d arm = mark.node - mark.foot;
        return std::ranges::any_of(layout_.marks, [&](const DimensionLayout::Mark& other) {
            const Vector2d its = other.node - other.foot;
            const bool is_here = std::abs(other.level - mark.level) <= nothing * scene_.shape.size;
            return is_here && its.dot(arm) > 0.0 && its.norm() < arm.norm();
        });
    }

    // From a little beside the node to a little beyond the line; nothing where the line is that near.
    void draw_leader(ui::Point node, ui::Point foot) const
    {
        Sketch& sketch = scene_.sketch;
        const double gap = sketch.px(9.0), beyond = sketch.px(7.0);
        if (ui::distance(node, foot) <= gap) return;
        const ui::Point along = ui::direction(foot - node);
        sketch.line(node + gap * along, foot + beyond * along, sketch.thin(ui::Role::Dimension), Clearance::Soft);
    }

    const Scene& scene_;
    const DimensionLayout& layout_;
    ui::Point outward_;
};

bool holds(const Highlight& highlight, DimensionPlace place)
{
    return std::ranges::find(highlight.dimensions, place) != highlight.dimensions.end();
}

} // namespace

void draw_drawn_dimensions(const Scene& scene, std::span<const DimensionLine> dimensions)
{
    if (!is_drawn_in(scene.model)) return;
    const ui::LayerScope layer(scene.sketch.painter(), ui::Layer::Symbols);
    for (std::size_t i = 0; i < dimensions.size(); ++i) {
        const DimensionLine& line = dimensions[i];
        const std::optional<DimensionLayout> layout = layout_of(scene.model, line);
        if (!layout) continue;
        const DrawnDimension drawn(scene, line, *layout);
        const DimensionPlace place{i};
        if (holds(scene.state.selection, place)) drawn.highlight(ui::Role::Selection);
        if (holds(scene.state.hover, place)) drawn.highlight(ui::Role::Hover);
        drawn.draw_leaders();
        drawn.draw_lengths();
        scene.sketch.mark(DimensionMark{place, drawn.start(), drawn.end()});
    }
}

std::vector<Eigen::Vector3d> ends_of_dimensions(const femoop::Model& model, std::span<const DimensionLine> dimensions)
{
    std::vector<Eigen::Vector3d> ends;
    if (!is_drawn_in(model)) return ends;
    for (const DimensionLine& line : dimensions)
        if (const auto layout = layout_of(model, line))
            for (const DimensionLayout::Mark& mark : layout->marks)
                ends.emplace_back(mark.foot.x(), mark.foot.y(), 0.0);
    return ends;
}

} // namespace drawing
