#pragma once

#include <string>

#include "ui/report/report.h"

namespace ui {

/// The report as one HTML file that needs no other: figures are SVG within it, and it prints well.
std::string report_html(const Report& report, const Fonts& fonts);

} // namespace ui
