#pragma once

#include <string>

#include "femoop/tabular/table.h"

namespace femoop {

/// A table as JSON: title and notes where it has them, the labels of its columns, and its rows as arrays; numbers have
/// every digit, whatever people are shown.
std::string table_json(const tabular::Table& table);

} // namespace femoop
