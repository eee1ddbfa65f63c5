#include "apps/frame/view/kept_view.h"

namespace frame {

namespace {

// Of an envelope of these; none where it is of all.
std::set<std::string> cases_beside(const std::vector<std::string>& chosen, const femoop::Model& model)
{
    std::set<std::string> others;
    if (chosen.empty()) return others;
    for (std::size_t i = 0; i < model.n_cases(); ++i) others.insert(model.case_name(femoop::CaseId(i)));
    for (const std::string& id : chosen) others.erase(id);
    return others;
}

} // namespace

void look_as(DrawOptions& options, const NamedView& view, const femoop::Model& model)
{
    options.show = view.show;
    options.is_envelope = !view.load_case;
    if (options.is_envelope || !view.envelope.empty()) options.left_out = cases_beside(view.envelope, model);
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
