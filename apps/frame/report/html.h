#pragma once

#include <string>

#include "apps/frame/report/report.h"

namespace frame {

/// The report as one HTML file that needs no other: figures are SVG within it, and it prints well.
std::string report_html(const Report& report, const ui::Fonts& fonts);

} // namespace frame
