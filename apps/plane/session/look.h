#pragma once

#include <optional>

#include "apps/plane/tools/readings.h"
#include "apps/plane/view/plate_picture.h"
#include "ui/paint/theme.h"
#include "ui/text/catalogue.h"
#include "ui/text/display_units.h"

namespace plane {

/// The range of the colours of a component, kept while results change.
struct KeptRange {
    femoop::plane::PlaneComponent component = femoop::plane::PlaneComponent::Mises;
    double low = 0.0, high = 1.0; ///< in the file's units
};

/// How a drawing is looked at.
struct Look {
    bool regions = true;
    bool supports = true;
    bool loads = true;
    bool values = true;
    bool names = false;
    bool legend = true;
    bool backdrop = true; ///< the image behind the drawing
    bool mesh = false;
    bool deformed = false;
    bool principal = false; ///< crosses of principal stresses
    bool trajectories = false;
    bool vectors = false;                                 ///< displacements as arrows
    bool lines = false;                                   ///< of equal value, in place of bands
    bool reactions = false;                               ///< of each support, as resultants
    bool error = false;                                   ///< of each element, estimated
    std::optional<femoop::plane::PlaneComponent> field{}; ///< that bands show
    std::optional<KeptRange> range{};                     ///< of the bands; that of the values when absent
    bool element_values = false;                          ///< with their jumps, in place of smoothed ones
    Readings readings{};                                  ///< probes and cuts
    bool modes = false;                                   ///< natural ones, in place of results
    std::size_t mode = 0;                                 ///< that is shown
    bool beside = false;                                  ///< results that are kept, in place of behind the others
    std::size_t n_cycles = 4;                             ///< of a refinement
    std::optional<ui::UnitSystem> units{};                ///< the file's own when absent
    ui::UnitChoices unit_choices{};                       ///< in place of those of the system
    ui::NumberFormat numbers{};                           ///< but for the mark, which is the language's
    bool circle = true; ///< Mohr's circle and all values of the last probe, in a panel
    ui::ThemeName theme = ui::ThemeName::Light;
    ui::Catalogue tr;
};

/// Whether what it shows needs the drawing's mesh, and results too.
bool needs_mesh(const Look& look);
bool needs_results(const Look& look); ///< never where modes are shown

/// What of a drawing its look shows, of a load case.
PlateOptions options_of(const Look& look, std::size_t load_case);

} // namespace plane
