#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "femoop/io/results/result_units.h"
#include "femoop/io/results/results_csv.h"
#include "femoop/model/fault/translator.h"
#include "femoop/plane/analysis/plane_results.h"
#include "femoop/plane/model/plane_expected.h"
#include "femoop/plane/model/plane_model.h"

namespace femoop::plane {

/// A point of a drawing, which may be a node of its mesh or a place in an element.
struct ShownPoint {
    std::string id;
    std::optional<NodeId> node;
    Eigen::Vector2d at;
};

/// The lines above results: title, analysis, units, size of the mesh. \param what  of the analysis, in the reader's words
std::string heading(const PlaneModel& model, const std::string& what, const Translator& tr);

double to_six_digits(double value); ///< as sentences below results have them

/// Whose extremes programs are told.
inline constexpr std::array shown_extremes{PlaneComponent::sx,   PlaneComponent::sy, PlaneComponent::sz,
                                           PlaneComponent::txy,  PlaneComponent::s1, PlaneComponent::s2,
                                           PlaneComponent::Mises};
/// The regions whose elements meet at each point, by which its stresses are told.
std::vector<std::vector<RegionId>> regions_of_points(const PlaneModel& model);

/// What is printed of a plane model beside what is printed always.
struct PlaneSelection {
    std::vector<CaseId> cases;
    std::vector<Eigen::Vector2d> probes;             ///< \pre each lies in material
    std::vector<Cut> cuts;                           ///< \pre each meets material
    bool is_full = false;                            ///< the mesh too, and all its nodes
    std::optional<std::vector<ShownPoint>> points{}; ///< of a drawing; absent: all points of the model
    std::vector<std::string> methods{}; ///< by which each region was meshed; empty where the mesh is the file's
};

/// The results as JSON, the shape that `cremona solve --json` prints:
///
///   {"cremona": 1, "units", "analysis", "mesh": {"nodes", "elements", "min_angle", "max_angle", "min_jacobian"},
///    "regions": {ID: {"area", "elements", "method"}},
///    "cases": {ID: {"points": {ID: {"u", "reaction", "stress": {REGION: {"sx", ..}}}}, "curves": {ID: {"reaction"}},
///              "regions": {ID: {"extremes": {"sx": {"max": {"at", "value"}, "min"}}}}, "probes", "cuts", "energy",
///              "error_estimate", "equilibrium": {"residual", "sum_loads", "sum_reactions"}}}}
///
/// Units  the model's base units; angles in degrees, `angle` from x to s1
std::string plane_results_json(const PlaneResults& results, const PlaneSelection& selection);

/// What the model is: title, kind of analysis, units, size of the mesh, warnings.
std::string plane_heading_text(const PlaneResults& results, const Translator& tr);

/// The cases for people: tables of displacements, reactions and extremes of stresses, of places and of cuts.
std::string plane_cases_text(const PlaneResults& results, const PlaneSelection& selection, const ResultUnits& units,
                             const Translator& tr);

/// The results in the model's base units, one table a file, for a spreadsheet:
///
///   displacements.csv  case, point, x, y, ux, uy: all nodes of the mesh
///   reactions.csv      case, point, x, y, fx, fy: nodes that are supported
///   curves.csv         case, curve, fx, fy, mz: what the supports of a curve do to all of its nodes
///   stresses.csv       case, point, x, y, region, sx, sy, sz, txy, s1, s2, angle, mises: smoothed, of all nodes
///   extremes.csv       case, region, component, unit, max, x and y of max, min, x and y of min
///   equilibrium.csv    case, what (loads, reactions), fx, fy, mz about the origin, residual
///   probes.csv         case, x, y, region, ux, uy, and stresses as above: where places are asked for
///   cuts.csv           case, cut, x1, y1, x2, y2, N, V, M: where cuts are asked for
///   stations.csv       case, cut, s, x, y, sx', sy', txy': along those
std::vector<CsvFile> plane_results_csv(const PlaneResults& results, const PlaneSelection& selection);

/// Every case but for places and cuts in one table, a value a row:
///
///   case, part (point, curve, largest, smallest, loads, reactions), id, region, x, y, component, value, unit
std::string plane_long_csv(const PlaneResults& results);

} // namespace femoop::plane
