#include "apps/drawing/structure/node_numbers.h"

#include "apps/drawing/sketch/scene.h"

namespace drawing {

void draw_node_numbers(const Scene& scene, std::span<const NodeNumbers> numbers)
{
    for (const NodeNumbers& of : numbers)
        scene.sketch.caption({.text = of.text,
                              .role = of.is_lit ? ui::Role::Selection : ui::Role::FaintLabel,
                              .target = scene.place(of.node),
                              .toward = {0.6, 0.8},
                              .gap = scene.sketch.px(6.0),
                              .rank = of.is_lit ? Rank::Largest : Rank::Minor,
                              .weight = of.is_lit ? ui::Weight::Bold : ui::Weight::Regular,
                              .reach = 60.0});
}

} // namespace drawing
