#include "apps/cross/view/sheet_parts.h"

#include "apps/cross/view/numbers.h"
#include "apps/drawing/sketch/scene.h"
#include "ui/text/number_format.h"

namespace cross {

std::vector<SheetPart> parts_of(const Scene& scene)
{
    const femoop::cross::Superposition& all = *scene.solution.task->all;
    std::vector<SheetPart> parts{{.sway = {}, .times = 1.0, .moments = all.held.sheet.end.moments}};
    for (std::size_t k = 0; k < all.sways.size(); ++k) {
        const double times = all.x[static_cast<Eigen::Index>(k)];
        parts.push_back({.sway = k, .times = times, .moments = all.sways[k].sheet.end.moments});
        for (double& moment : parts.back().moments) moment *= times;
    }
    return parts;
}

std::string words_of(const SheetPart& part, const Scene& scene)
{
    const ui::Catalogue& tr = scene.look.tr;
    if (!part.sway) return tr("loads");
    const femoop::NodeId prop = scene.solution.task->problem.sways[*part.sway].prop;
    if (part.times == 0.0) return tr("no sway at {node}", {{"node", scene.document.model[prop].id}});
    const ui::DecimalMark mark = units_of(scene.document.model, tr).format().mark;
    return tr("{times} × sway at {node}", {{"times", drawing::with_minus(ui::number_text(part.times, {4, mark}))},
                                           {"node", scene.document.model[prop].id}});
}

} // namespace cross
