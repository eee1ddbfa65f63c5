#pragma once

#include "femoop/model/property.h"
#include "femoop/model/quantity/units.h"
#include "ui/paint/painter.h"
#include "ui/paint/theme.h"
#include "ui/text/display_units.h"

namespace drawing {

/// How a section is drawn.
struct SectionLook {
    ui::Theme theme;
    ui::DisplayUnits units;
};

/// Draws a cross-section on the painter's whole sheet, as one sees it who looks along +x' (femoop/section/outline.h):
/// its area, its centroid with the axes y' and z', the principal axes where they differ, and its dimensions. Nothing
/// for a section that is given by numbers alone.
void draw_section(ui::Painter& painter, const femoop::Section& section, const femoop::Units& file,
                  const SectionLook& look);

/// The bare area alone, as large as the sheet allows: a small picture to choose by.
void draw_section_icon(ui::Painter& painter, const femoop::SectionShape& shape, const ui::Theme& theme);

} // namespace drawing
