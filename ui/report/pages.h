#pragma once

#include <vector>

#include "ui/paint/surface/pdf.h"
#include "ui/report/report.h"

namespace ui {

/// The report on upright A4 pages with numbers: a table goes on with its headings on the next page, and a heading is
/// never the last thing on one.
std::vector<PdfPage> report_pages(const Report& report, const Fonts& fonts);

} // namespace ui
