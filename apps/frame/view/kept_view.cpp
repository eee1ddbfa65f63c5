#include "apps/frame/view/kept_view.h"

namespace frame {

void look_as(ViewOptions& options, const NamedView& view, const femoop::Model& model)
{
    options.show = parse_show(view.show);
    options.is_envelope = !view.load_case;
    if (const auto id = view.load_case ? model.find_case(*view.load_case) : std::nullopt) options.load_case = *id;
    options.diagram_factor = view.diagrams;
    options.load_factor = view.loads;
    options.deformation_scale = view.displacements;
}

ui::PlaneCamera camera_on(const Region& region, ui::Size panel)
{
    const double scale = panel.height / region.height;
    const ui::Point middle{0.5 * panel.width, 0.5 * panel.height};
    return ui::PlaneCamera({middle.x - scale * region.centre.x(), middle.y + scale * region.centre.y()}, scale);
}

} // namespace frame
