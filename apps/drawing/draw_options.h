#pragma once

#include "apps/drawing/moment_side.h"
#include "apps/drawing/show.h"
#include "femoop/model/ids.h"
#include "ui/paint/theme.h"
#include "ui/text/catalogue.h"
#include "ui/text/display_units.h"

#include <cstdint>
#include <optional>
#include <set>
#include <string>

namespace drawing {

/// Whether each result gets a panel of its own beside the loads, or all are drawn over one another.
enum class Layout : std::uint8_t {
    Automatic,    ///< a panel for the loads and reactions, and one for each result
    LoadsOnFirst, ///< likewise, the loads and reactions with the first of the results
    Overlay
};

/// What its reader chose of a picture: it lasts until he chooses again. Factors are 1 where the automatic size is
/// right. What the picture is of is DrawInput; what lasts a moment is DrawState.
struct DrawOptions {
    ShowSet show = shown_by_default;
    femoop::CaseId load_case; ///< whose loads and results are drawn
    ui::ThemeName theme = ui::ThemeName::Light;
    ui::Catalogue tr;                      ///< language of the words
    std::optional<ui::UnitSystem> units;   ///< kN, m, mm (or kip, ft, in) when absent
    ui::UnitChoices unit_choices{};        ///< of single quantities, in place of those
    ui::NumberFormat numbers{.digits = 4}; ///< digits and decimal mark
    bool is_envelope = false; ///< of several cases instead of one: diagrams as bands, reactions as ranges, no loads
    /// Names of the load cases and combinations that the envelope is without; a name that the model lacks counts for
    /// nothing, so cases that come and go need no care.
    std::set<std::string> left_out;
    MomentSide moment_side = MomentSide::Tension;
    int steps = 10;                          ///< of every member, for Show::StepValues; > 0
    double diagram_factor = 1.0;             ///< > 0
    double load_factor = 1.0;                ///< > 0, length of the arrows
    double symbol_factor = 1.0;              ///< > 0, size of supports, hinges and heads of arrows
    std::optional<double> deformation_scale; ///< 50 draws displacements fifty times as large
    Layout layout = Layout::Automatic;
};

} // namespace drawing
