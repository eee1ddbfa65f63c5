#include "apps/drawing/results/counting_marks.h"

#include "ui/paint/painter.h"

#include <string>

namespace drawing {

namespace {

using namespace femoop::counting;

std::string summand(int n) { return (n < 0 ? "−" : "+") + std::to_string(n < 0 ? -n : n); }

void write(const Scene& scene, ui::Point target, int n, ui::Role role, ui::Point toward, double gap)
{
    scene.sketch.caption({.text = summand(n),
                          .role = role,
                          .target = target,
                          .toward = toward,
                          .gap = gap,
                          .rank = Rank::Value,
                          .weight = ui::Weight::Bold,
                          .size = scene.sketch.theme().type().large});
}

/// The number in a circle with the forces beside it, which stand together.
void draw_ring(const Scene& scene, const Ring& ring, std::size_t number, int n_forces)
{
    Sketch& sketch = scene.sketch;
    const ui::Theme& theme = sketch.theme();
    const double em = theme.type().large, radius = 0.85 * em;
    const ui::Point middle = scene.projection(ring.middle) - ui::Point{em, 0.0};
    sketch.disc(middle, radius, theme.background());
    sketch.ring(middle, radius, sketch.thin(ui::Role::Dimension));
    sketch.painter().text(middle, std::to_string(number), theme.text(ui::Role::Label, ui::Anchor::Center));
    ui::TextStyle style = theme.text(ui::Role::Label, ui::Anchor::Left);
    style.weight = ui::Weight::Bold;
    style.size = em;
    const ui::Point beside = middle + ui::Point{radius + 4.0, 0.0};
    sketch.painter().text(beside, summand(n_forces), style);
    sketch.keep_clear({beside - ui::Point{0.0, 0.6 * em}, beside + ui::Point{1.6 * em, -0.6 * em},
                       beside + ui::Point{1.6 * em, 0.6 * em}, beside + ui::Point{0.0, 0.6 * em}});
}

} // namespace

void draw_counting(const Scene& scene, const Counting& counting)
{
    const ui::LayerScope layer(scene.sketch.painter(), ui::Layer::Symbols);
    for (std::size_t i = 0; i < counting.rings.size(); ++i)
        draw_ring(scene, counting.rings[i], i + 1, counting.forces_per_ring());
    const double beside = scene.sketch.px(8.0);
    for (const ReleasedJoint& joint : counting.releases)
        if (joint.count() != 0)
            write(scene, scene.place(joint.node), -joint.count(), ui::Role::Hinge, {0.7, -0.7}, beside);
    for (const SupportReactions& support : counting.reactions)
        if (support.count() != 0)
            write(scene, scene.place(support.node), support.count(), ui::Role::Reaction, {-0.8, 0.6}, beside);
}

} // namespace drawing
