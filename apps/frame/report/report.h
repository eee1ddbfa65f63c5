#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "apps/frame/document/solution.h"
#include "apps/frame/view/view_options.h"
#include "femoop/model/model.h"
#include "ui/paint/picture.h"
#include "ui/paint/text_measure.h"

namespace frame {

/// A calculation report as blocks, to be laid out as a page of the web (html.h) or on sheets of paper (pages.h).
struct ReportHeading {
    int level = 2; ///< 1: the title; 2, 3, 4: chapters, their parts and the parts of these
    std::string text;
};
struct ReportText {
    std::string text;
};
struct ReportTable {
    struct Column {
        std::string heading;
        bool is_number = false;
    };
    std::vector<Column> columns;
    std::vector<std::vector<std::string>> rows;
};
struct ReportFigure {
    ui::Picture picture;
    std::string caption;
};
using ReportBlock = std::variant<ReportHeading, ReportText, ReportTable, ReportFigure>;

struct Report {
    std::string title;
    std::string language; ///< as HTML names it: "en", "pt-BR"
    std::vector<ReportBlock> blocks;
};

/// Data alone is a sheet of homework: the structure and its loads, for somebody to find the results.
enum class ReportAbout : std::uint8_t { Everything, Data };

struct ReportOptions {
    ViewOptions view;      ///< language, units, digits; figures are drawn in the print theme
    bool matrices = false; ///< the stiffness and the transformation of every member too
    ReportAbout about = ReportAbout::Everything;
};

/// Data, numbering, results of every load case and combination with their figures, and the check of equilibrium. A
/// model that cannot be solved is reported with the reasons.
Report make_report(const femoop::Model& model, const Solution& solution, const ReportOptions& options,
                   const ui::Fonts& fonts);

} // namespace frame
