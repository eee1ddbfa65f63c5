#pragma once

#include "apps/drawing/geometry/diagram_plan.h"
#include "apps/drawing/sheet/panel_head.h"
#include "apps/drawing/sketch/scene.h"
#include "femoop/methods/truss/reciprocal.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace drawing {

/// A truss with Bow's notation and its Cremona diagram, as far as it has been drawn.
struct CremonaPicture {
    femoop::truss::Truss truss;
    femoop::truss::Reciprocal diagram;
    std::vector<std::string> sentences{}; ///< what each stage does; that of the last one drawn stands at the foot
    std::size_t n_stages = 0;             ///< of Reciprocal::steps that are drawn

    bool is_found(femoop::MemberId bar) const; ///< at a stage that is drawn
    bool is_known(femoop::truss::SpaceId space) const;
};

/// With all stages. \pre femoop::truss::why_no_reciprocal says nothing
CremonaPicture cremona_picture(const femoop::Model& model, const femoop::truss::Truss& truss, const ui::Catalogue& tr);

/// The truss: bars by their sense, in tension a full line, in compression dashes, dots where they carry nothing; the
/// forces from outside, whole, and the name of each space. Bars that are not found yet are thin.
void draw_truss(const Scene& scene, const CremonaPicture& picture);
PanelHead truss_head(const Scene& scene);

/// Of the points of its spaces.
DiagramPlan plan_of(const femoop::truss::Reciprocal& diagram, const ui::Box& panel, const ui::Theme& theme);

/// The diagram: each side with the line of its bar, the points with the small letters of their spaces.
void draw_reciprocal(const Scene& scene, const CremonaPicture& picture, const ui::Box& panel);
PanelHead reciprocal_head(const Scene& scene, const CremonaPicture& picture, const ui::Box& panel);

/// The bar whose side lies at this place of the sheet, at most `reach` pixels off, among those that are drawn.
std::optional<femoop::MemberId> side_at(const CremonaPicture& picture, const DiagramPlan& plan, ui::Point at,
                                        double reach);

} // namespace drawing
