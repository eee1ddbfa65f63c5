#pragma once

#include "apps/drawing/dimension.h"
#include "apps/drawing/geometry/projection.h"
#include "apps/drawing/moment_side.h"
#include "apps/drawing/part.h"
#include "apps/drawing/show.h"
#include "femoop/analysis/mechanism.h"
#include "femoop/model/ids.h"
#include "femoop/model/model.h"
#include "femoop/result/results.h"
#include "ui/paint/theme.h"
#include "ui/text/catalogue.h"
#include "ui/text/display_units.h"

#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace drawing {

class MomentOverlay;

/// Whether each result gets a panel of its own beside the loads, or all are drawn over one another.
enum class Layout : std::uint8_t {
    Automatic, ///< a panel for the loads and reactions, and one for each result
    Overlay
};

/// What the cursor is over, or what is selected: drawn with a broad line below it.
struct Highlight {
    std::vector<femoop::NodeId> nodes;
    std::vector<femoop::MemberId> members;
    std::vector<DimensionPlace> dimensions{};
};

/// One of the motions of a structure that cannot be solved.
struct MotionChoice {
    std::span<const femoop::Mechanism> all; ///< outlives whatever draws it
    std::size_t shown = 0;                  ///< \pre < all.size()
    std::string sentence;                   ///< how the structure moves, in the words of the app
};

/// A former model with its results, kept to be compared with.
struct Ghost {
    femoop::Model model;
    femoop::Results results;
};

/// How a model is drawn. Factors are 1 where the automatic size is right.
struct ViewOptions {
    ShowSet show = shown_by_default;
    femoop::CaseId load_case; ///< whose loads and results are drawn
    ui::ThemeName theme = ui::ThemeName::Light;
    ui::Catalogue tr;                      ///< language of the words
    std::optional<ui::UnitSystem> units;   ///< kN, m, mm (or kip, ft, in) when absent
    ui::NumberFormat numbers{.digits = 4}; ///< digits and decimal mark
    bool is_envelope = false; ///< of several cases instead of one: diagrams as bands, reactions as ranges, no loads
    /// Names of the load cases and combinations that the envelope is without; a name that the model lacks counts for
    /// nothing, so cases that come and go need no care.
    std::set<std::string> left_out;
    std::shared_ptr<const Ghost> ghost; ///< its diagrams are drawn behind, faint; none when null
    /// What an app draws over the moments, or in their place; outlives whatever draws it. While moments are not shown a
    /// fitted picture keeps room for it. None when null.
    const MomentOverlay* overlay = nullptr;
    std::span<const DimensionLine> dimensions; ///< drawn by hand; outlive whatever draws them
    MomentSide moment_side = MomentSide::Tension;
    int steps = 10;                          ///< of every member, for Show::StepValues; > 0
    double diagram_factor = 1.0;             ///< > 0
    double load_factor = 1.0;                ///< > 0, length of the arrows
    double symbol_factor = 1.0;              ///< > 0, size of supports, hinges and heads of arrows
    std::optional<double> deformation_scale; ///< 50 draws displacements fifty times as large
    /// Whose largest values set the scales of diagrams and displacements; those of the results drawn when absent.
    std::optional<femoop::Results> scaled_by;
    double phase = 1.0;           ///< share of the displacement that is drawn, -1 to 1: animation
    std::optional<Camera> camera; ///< fits the sheet when absent
    Layout layout = Layout::Automatic;
    Highlight hover, selection;
};

} // namespace drawing
