#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "femoop/tabular/table.h"

namespace tabular {

struct PlainTextLook {
    std::size_t indent = 0; ///< blanks before every line
    char decimal_mark = '.';
};

/// A table for a terminal: words to the left, numbers on their decimal marks. Title and notes are left out.
///
/// A column of numbers keeps one count of decimals, six significant digits of its largest number of a kind, so that
/// round-off beside large numbers reads 0; very large and very small columns are written with powers of ten.
/// Every line ends with a line break; none has blanks at its end.
std::string plain_text(const Table& table, const PlainTextLook& look = {});

/// How many characters a terminal shows for a UTF-8 text.
std::size_t shown_width(std::string_view utf8);

} // namespace tabular
