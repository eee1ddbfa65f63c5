#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/plane/view/plate_picture.h"
#include "femoop/plane/result/triangulated_field.h"
#include "ui/paint/color.h"

namespace plane {

struct PlateScene;

/// A field over the body as it is drawn: the same for its colours, its lines and its legend.
struct FieldPicture {
    FieldStyle style = FieldStyle::Bands;
    femoop::plane::TriangulatedField field; ///< at rest
    std::vector<double> levels;
    std::vector<ui::Color> colors;                          ///< of the bands between levels
    std::optional<femoop::plane::FieldExtremes> extremes{}; ///< with their places; none of errors
    bool goes_beyond_nodes = false;                         ///< it has values that no node has
    ui::Measure measure = ui::Measure::Stress;
    double shown = 1.0;       ///< what a value is multiplied by besides its unit: 100 of a share in percent
    std::string symbol, unit; ///< "σx", "kN/m²"
    std::vector<std::string> notes;

    /// A value without its unit.
    std::string number(double value, const ui::DisplayUnits& units) const;
};

/// "σx" as books write it.
std::string symbol_of(femoop::plane::PlaneComponent component);
ui::Measure measure_of(femoop::plane::PlaneComponent component);

FieldPicture field_picture(const FieldShow& show, const femoop::plane::PlaneCase& result, const PlateOptions& options,
                           const ui::DisplayUnits& units);
/// Zienkiewicz and Zhu's error of each element, in percent of the norm of the whole body's stresses.
FieldPicture error_picture(const femoop::plane::PlaneCase& result, const PlateOptions& options);

/// Its bands in colours, or its lines with their values; where its values are shown, its extremes at their places.
void draw_field(const PlateScene& scene, const FieldPicture& picture);

/// How wide the legend of colours is, and the legend in a box as wide.
double legend_width(const FieldPicture& picture, const ui::DisplayUnits& units, const ui::Theme& theme,
                    const ui::Fonts& fonts);
void draw_legend(ui::Painter& painter, const FieldPicture& picture, const ui::DisplayUnits& units,
                 const ui::Theme& theme, const ui::Box& box);

} // namespace plane
