#pragma once

#include <string>
#include <variant>
#include <vector>

#include "femoop/tabular/table.h"
#include "ui/paint/picture.h"

namespace ui {

/// A calculation report as blocks, to be laid out as a page of the web (html.h) or on sheets of paper (pages.h).
struct ReportHeading {
    int level = 2; ///< 1: the title; 2, 3, 4: chapters, their parts and the parts of these
    std::string text;
};
struct ReportText {
    std::string text;
};
struct ReportFigure {
    Picture picture;
    std::string caption;
};
using ReportBlock = std::variant<ReportHeading, ReportText, tabular::Table, ReportFigure>;

struct Report {
    std::string title;
    std::string language; ///< as HTML names it: "en", "pt-BR"
    std::vector<ReportBlock> blocks;
};

} // namespace ui
