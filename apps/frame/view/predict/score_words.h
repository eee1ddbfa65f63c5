#pragma once

#include <string>
#include <vector>

#include "apps/drawing/geometry/structure_shape.h"
#include "apps/frame/document/drawing_names.h"
#include "apps/frame/predict/prediction.h"
#include "ui/text/catalogue.h"
#include "ui/text/display_units.h"

namespace frame {

/// "85 %"
std::string percent(double share, const ui::Catalogue& tr);

/// What the sentences about an assessment are made from.
struct ScoreWords {
    const femoop::Model& model;
    const StructureShape& shape;
    const ui::DisplayUnits& units;
    const ui::Catalogue& tr;

    /// What is wrong with one member's guess, as a teacher would say it; empty where nothing is.
    /// \param is_of_line  an influence line was guessed, not moments
    std::vector<std::string> faults(const MemberMark& mark, bool is_of_line = false) const;
    /// The share of all points, then the members whose guess has faults, the worst first, a line each, and in one line
    /// those that are right; six lines at most.
    std::vector<std::string> lines(const Assessment& assessment) const;
};

} // namespace frame
