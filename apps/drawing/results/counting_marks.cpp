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

void draw_ring(const Scene& scene, const Ring& ring, std::size_t number, int n_forces)
{
    Sketch& sketch = scene.sketch;
    const ui::Point middle = scene.projection(ring.middle);
    const double radius = 0.85 * sketch.theme().type().large;
    sketch.disc(middle, radius, sketch.theme().background());
    sketch.ring(middle, radius, sketch.thin(ui::Role::Dimension));
    sketch.painter().text(middle, std::to_string(number), sketch.theme().text(ui::Role::Label, ui::Anchor::Center));
    write(scene, middle, n_forces, ui::Role::Label, {1.0, 0.0}, radius + 4.0);
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
