#pragma once

#include <vector>

#include "apps/frame/report/report.h"
#include "ui/paint/surface/pdf.h"

namespace frame {

/// The report on upright A4 pages with numbers: a table goes on with its headings on the next page, and a heading is
/// never the last thing on one.
std::vector<ui::PdfPage> report_pages(const Report& report, const ui::Fonts& fonts);

} // namespace frame
