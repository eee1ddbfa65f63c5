#pragma once

#include <string>
#include <string_view>

#include "femoop/tabular/table.h"

namespace tabular {

/// A text as HTML shows it; its line ends become <br>.
std::string html_text(std::string_view text);

/// A <table> of its own, its headings in <thead>; cells of columns that stand to the right are of the class "n". Title
/// and notes are left out.
std::string html(const Table& table);

} // namespace tabular
