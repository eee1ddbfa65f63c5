#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "femoop/analysis/trace.h"
#include "femoop/model/model.h"
#include "femoop/result/results.h"

namespace femoop {

/// The results of these cases as JSON, the shape that `cremona solve --json` prints and
/// courseware/reference/command-line.md documents:
///
///   {"cremona": 1, "units": {"length", "force"}, "cases": {ID: {"nodes", "members", "equilibrium"}}}
///
/// Units     the model's base units, rotations in rad
/// Accuracy  shortest numbers that read back as the same double; -0 is 0; nothing is ever NaN or infinite
/// `n_stations` evenly spaced stations along each member, and every load point (a jump gives two at one x).
std::string results_json(const Model& model, const Results& results, const std::vector<CaseId>& cases,
                         std::size_t n_stations);

/// The envelope over these cases: every value is {"max": {"value", "case"}, "min": ...}; extremes have "x" too.
///
///   {"cremona": 1, "units": ..., "envelope": {"cases": [ID...], "nodes": {ID: {"u", "reaction"}},
///    "members": {ID: {"extremes", "stations"}}}}
std::string envelope_json(const Model& model, const Results& results, const std::vector<CaseId>& cases,
                          std::size_t n_stations);

/// How one member entered the system: matrices are lists of rows, the fields of MemberTrace by name.
std::string trace_json(const MemberTrace& trace, const Units& units);

} // namespace femoop
