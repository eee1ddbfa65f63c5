#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/plane/view/plate_scene.h"
#include "femoop/plane/result/cut_balance.h"
#include "femoop/plane/result/cut_theory.h"

namespace plane {

/// A cut with what acts on it, and what the theory of beams says of it.
struct CutPicture {
    femoop::plane::Cut cut;
    femoop::plane::CutForces forces;
    std::vector<femoop::plane::CutStation> stations; ///< none where it meets no material
    femoop::plane::CutTheory theory;
    std::optional<femoop::plane::CutWarning> warning{}; ///< where its stresses do not balance what lies beyond it
    /// In English, to be translated: why it tells nothing; it meets no material, or the body is one of revolution.
    std::optional<std::string_view> hindrance{};
};
CutPicture cut_picture(const femoop::plane::PlaneResults& results, const femoop::plane::PlaneCase& result,
                       const femoop::plane::Cut& cut);

/// The line of the cut across the body, its first end marked; the n-th of them, counted from 1.
void draw_cut(const PlateScene& scene, const femoop::plane::Cut& cut, std::size_t n);

/// sigma and tau along the cut, those of the elements as areas and those of beam theory as dashes, with N, V and M.
/// The cut runs upwards in its panel.
void draw_cut_panel(ui::Painter& painter, const CutPicture& picture, std::size_t n, const PlateOptions& options,
                    const ui::DisplayUnits& units, const ui::Box& box);

/// How narrow and how high a panel may be, and how many stand beside each other on a sheet as wide.
double cut_panel_height(const ui::Theme& theme);
double cut_panel_width(const ui::Theme& theme); ///< that its type wants
std::size_t most_cuts(const ui::Theme& theme, double width);

} // namespace plane
