#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "femoop/methods/mohr/criterion.h"
#include "femoop/methods/mohr/rosette.h"
#include "femoop/methods/mohr/state.h"
#include "ui/text/catalogue.h"

namespace cli {

/// What `cremona mohr` is asked for: a state, and a plane through it.
struct MohrProblem {
    femoop::mohr::State state;
    std::optional<femoop::mohr::Rosette> rosette; ///< that the state, a strain, was read from
    double reading_unit = 1.0;                    ///< of the strains, where stresses follow from them
    std::string unit;                             ///< of the components, as typed; "" for bare numbers
    std::string stress_unit;                      ///< of E, so of stresses that follow from strains
    std::optional<double> angle;                  ///< of the turned axes [degrees]
    std::optional<Eigen::Vector3d> normal;
    std::optional<femoop::mohr::Criterion> criterion; ///< of failure
    femoop::mohr::Strength strength{};                ///< in the unit of the stresses
};

/// A problem in words, as the options and the case files give it; "" and empty lists where nothing is given.
struct MohrWords {
    std::vector<std::string> stress, strain, inertia, rosette_angles, rosette_readings, normal;
    std::vector<std::string> strength; ///< "fy=250 MPa"
    std::string E, nu, angle, criterion;
    std::string reading_unit;
    bool is_plane_strain = false;
};

/// \throws UsageError naming the option
MohrProblem mohr_problem(const MohrWords& words, const ui::Catalogue& tr);

} // namespace cli
