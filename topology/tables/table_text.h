#pragma once

#include <string>

#include "topology/tables/entity_tables.h"

namespace topology {

/// The tables of the half-edge structure as the lecture prints them, a line for each entity that lives:
///
///    V = 1 (H = 1) N = 0 P = 2
///    H = 1 (V = 1, E = 1, L = 1) N = 2 P = 2
///    E = 1 (H1 = 2, H2 = 1) N = 0 P = 0
///    L = 1 (H = 2, F = 1) N = 0 P = 0
///    F = 1 (S = 1, LOUT = 0 / LOOPS = 1) N = 0 P = 0
///    S = 1 (V = 1, F = 1, E = 1) N = 0 P = 0
///
/// entity_tables() says what stands in the cells.
std::string table_text(const Solid& solid, const SolidPlace& place = {});
void append_table_text(std::string& text, const Solid& solid, const SolidPlace& place = {});
std::string line_text(const TableRow& row); ///< "V = 1 (H = 1) N = 0 P = 2"

} // namespace topology
