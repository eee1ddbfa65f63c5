#include "apps/drawing/structure/supports.h"

#include "apps/drawing/structure/plane_supports.h"
#include "apps/drawing/structure/space_supports.h"

namespace drawing {

void draw_supports(const Scene& scene)
{
    for (std::size_t i = 0; i < scene.model.nodes.size(); ++i) {
        const femoop::NodeId node{i};
        if (!scene.model[node].support) continue;
        if (scene.is_flat()) draw_plane_support(scene, node);
        else draw_space_support(scene, node);
    }
}

std::optional<Eigen::Vector3d> support_side_in_model(const Scene& scene, femoop::NodeId node)
{
    if (!scene.model[node].support) return std::nullopt;
    if (!scene.is_flat()) return space_support_side(scene, node);
    return plane_support_side(scene, node);
}

std::optional<ui::Point> support_side(const Scene& scene, femoop::NodeId node)
{
    const auto side = support_side_in_model(scene, node);
    if (!side) return std::nullopt;
    return scene.projection.direction(*side);
}

double support_reach(const Sketch& sketch) { return sketch.px(30.0); }

} // namespace drawing
