#pragma once

#include <optional>
#include <string>
#include <vector>

#include "femoop/model/fault/translator.h"
#include "femoop/plane/analysis/plane_results.h"

namespace femoop::plane {

/// A point of a drawing, which may be a node of its mesh or a place in an element.
struct ShownPoint {
    std::string id;
    std::optional<NodeId> node;
    Eigen::Vector2d at;
};

/// The lines above results: title, analysis, units, size of the mesh. \param what  of the analysis, in the reader's words
std::string heading(const PlaneModel& model, const std::string& what, const Translator& tr);

double six_digits(double value); ///< as sentences below results have them

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

/// The same for people: tables of reactions, displacements and extremes of stresses.
std::string plane_results_text(const PlaneResults& results, const PlaneSelection& selection,
                               const Translator& tr = english);

} // namespace femoop::plane
