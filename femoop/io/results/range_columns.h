#pragma once

#include "femoop/tabular/separated.h"

namespace femoop {

/// Heads of what an envelope has for each of its rows: both values, each with its case.
inline void add_range_columns(tabular::SeparatedText& csv)
{
    for (const char* head : {"max", "case of max", "min", "case of min"}) csv << head;
}

} // namespace femoop
