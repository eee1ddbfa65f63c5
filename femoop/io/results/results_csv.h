#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "femoop/model/model.h"
#include "femoop/result/results.h"

namespace femoop {

/// Evenly spaced places along each member in files of results, where nobody asks for another number of them.
inline constexpr std::size_t usual_n_stations = 21;

/// A table as comma-separated values (RFC 4180): the first line names the columns with their units, "ux [m]";
/// decimal points; numbers are the shortest that read back as the same double, and what is nothing but rounding beside
/// the other numbers of its case is 0 (magnitudes.h).
struct CsvFile {
    std::string name; ///< "displacements.csv"
    std::string text;
};

/// The results of these cases, one table a file:
///
///   displacements.csv  case, node, and a column for each degree of freedom
///   reactions.csv      case, node, and a column for each force; supported nodes only
///   members.csv        case, member, x, and every section force and local displacement at each station
///   extremes.csv       case, member, component, unit, max, x of max, min, x of min
///   equilibrium.csv    case, what (loads, reactions), the sums of forces and moments about the origin, residual
std::vector<CsvFile> results_csv(const Model& model, const Results& results, const std::vector<CaseId>& cases,
                                 std::size_t n_stations);

/// The envelope over these cases:
///
///   envelope_nodes.csv    node, result, unit, max, case of max, min, case of min
///   envelope_members.csv  member, component, unit, max, x, case, min, x, case
std::vector<CsvFile> envelope_csv(const Model& model, const Results& results, const std::vector<CaseId>& cases);

/// The envelope over these cases in one long table: part (node or member), id, x, component, unit, max, case of max,
/// min, case of min; members at each station.
std::string long_envelope_csv(const Model& model, const Results& results, const std::vector<CaseId>& cases,
                              std::size_t n_stations);

/// Everything in one long table: case, part (node or member), id, x, component, value, unit.
std::string long_csv(const Model& model, const Results& results, const std::vector<CaseId>& cases,
                     std::size_t n_stations);

} // namespace femoop
