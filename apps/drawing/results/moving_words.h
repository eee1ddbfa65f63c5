#pragma once

#include "apps/drawing/draw_options.h"
#include "femoop/methods/influence/piecewise_line.h"
#include "femoop/methods/influence/train/train_search.h"
#include "ui/text/display_units.h"

#include <string>
#include <vector>

namespace drawing {

/// Where a line is largest or least: "20 ft", and of a level stretch "20 ft to 40 ft".
std::vector<std::string> places_text(const DrawOptions& options, const ui::DisplayUnits& units,
                                     const femoop::influence::LineExtreme& extreme);

/// A title and lines below it, as those of femoop `describe`.
std::string paragraph(const std::string& title, const std::vector<std::string>& lines);

/// "leading axle at s = 20 ft, running backwards"
std::string leading_axle_words(const DrawOptions& options, const ui::DisplayUnits& units, double position,
                               bool is_reversed);

/// The sentence, and after a colon where the axles stand, the uniform load lies, the single forces are.
std::string with_places(std::string sentence, const DrawOptions& options, const ui::DisplayUnits& units,
                        const femoop::influence::Placing& placing, bool has_axles, bool has_uniform);

} // namespace drawing
