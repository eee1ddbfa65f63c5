#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "apps/drawing/dimension.h"
#include "apps/drawing/draw_options.h"
#include "apps/drawing/truss/truss_picture.h"
#include "apps/frame/document/drawing_names.h"
#include "apps/frame/document/solution.h"
#include "femoop/model/model.h"
#include "ui/paint/text_measure.h"
#include "ui/report/report.h"

namespace frame {

/// Data alone is a sheet of homework: the structure and its loads, for somebody to find the results.
enum class ReportAbout : std::uint8_t { Everything, Data };

struct ReportOptions {
    DrawOptions view;                            ///< language, units, digits; figures are drawn in the print theme
    std::span<const DimensionLine> dimensions{}; ///< drawn by hand; outlive the writing
    bool matrices = false;                       ///< the stiffness and the transformation of every member too
    ReportAbout about = ReportAbout::Everything;
    std::optional<TrussMethod> truss{}; ///< a plane truss is worked out by hand too, in every case that allows it
};

/// Data, numbering, results of every load case and combination with their figures, and the check of equilibrium. A
/// model that cannot be solved is reported with the reasons.
ui::Report make_report(const femoop::Model& model, const Solution& solution, const ReportOptions& options,
                       const ui::Fonts& fonts);

} // namespace frame
