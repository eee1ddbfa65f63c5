#include "apps/drawing/truss/beside_truss.h"

#include "apps/drawing/truss/cremona_picture.h"
#include "apps/drawing/truss/joint_picture.h"

namespace drawing {

void draw_beside_truss(const Scene& scene, const TrussPicture& picture, const ui::Box& panel)
{
    if (picture.diagram) draw_reciprocal(scene, picture, panel);
    else draw_joint(scene, picture, panel);
}

PanelHead beside_truss_head(const Scene& scene, const TrussPicture& picture, const ui::Box& panel)
{
    return picture.diagram ? reciprocal_head(scene, picture, panel) : joint_head(scene, picture, panel);
}

std::optional<femoop::MemberId> bar_beside_at(const TrussPicture& picture, const ui::Box& panel, const ui::Theme& theme,
                                              ui::Point at, double reach)
{
    if (picture.diagram) return side_at(picture, plan_of(*picture.diagram, panel, theme), at, reach);
    return bar_of_joint_at(picture, panel, theme, at, reach);
}

} // namespace drawing
