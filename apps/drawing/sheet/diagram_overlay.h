#pragma once

#include "apps/drawing/results/diagram.h"
#include "apps/drawing/results/influence_picture.h"
#include "apps/drawing/results/solved_case.h"
#include "apps/drawing/sheet/panel_head.h"
#include "apps/drawing/sketch/scene.h"

#include <string>
#include <vector>

namespace drawing {

/// What sentences about a structure are made from.
struct TextContext {
    const femoop::Model& model;
    const StructureShape& shape;
    const ui::DisplayUnits& units;
    const ui::Catalogue& tr;
};

/// What an app draws over the bending moments or an influence line, such as what a class sketched of them before it saw
/// them.
class DiagramOverlay {
public:
    virtual ~DiagramOverlay() = default;

    virtual bool is_empty() const = 0;
    /// Where neither is shown.
    virtual void draw_alone(const Scene& scene) const = 0;
    virtual void draw_beside(const Scene& scene, const SolvedCase& solved, const Diagram& moments) const = 0;
    /// On a line, whether it is seen or kept from sight.
    virtual void draw_on_line(const Scene& scene, const InfluencePicture& line, const InfluenceScale& scale) const = 0;
    virtual PanelHead head(const Scene& scene) const = 0;
    /// What stands at the foot of the sheet where the moments of one case are shown, the first line in bold, or below
    /// the sentences of the line.
    virtual std::vector<std::string> foot(const TextContext& context) const = 0;
};

} // namespace drawing
