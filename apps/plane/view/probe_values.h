#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "apps/mohr/view/stress_circle.h"
#include "femoop/plane/analysis/plane_results.h"
#include "ui/text/display_units.h"

namespace plane {

/// A number at a place of the body.
struct ProbeValue {
    std::string symbol; ///< "σx"
    ui::Measure measure = ui::Measure::Stress;
    double smoothed = 0.0; ///< of a displacement the only one
    std::optional<double>
        element{};                ///< the mean of the elements of the region that hold the place; none of displacements
    std::optional<double> jump{}; ///< largest less smallest of them, where the place is on a border of elements
};

/// What a probe reads, of one region where several meet.
struct ProbeState {
    std::vector<ProbeValue>
        values; ///< ux, uy, sx, sy, sz where it is not 0 by itself, txy, s1, s2, theta1 [degrees], mises
    femoop::plane::PlaneStress smoothed;
    std::size_t n_elements = 0; ///< of the region that hold the place
    std::string region{};       ///< its name
    struct Beyond {
        std::string region;
        femoop::plane::PlaneStress smoothed;
    };
    std::vector<Beyond> beyond{}; ///< other regions that meet here
};

/// The state at a place; nothing where the place is in no element. What is rounding beside the largest stress is 0.
std::optional<ProbeState> probe_state(const femoop::plane::PlaneResults& results,
                                      const femoop::plane::PlaneCase& result, const Eigen::Vector2d& at);

/// What Mohr's circle is drawn of: the smoothed stresses, in the unit that stresses are shown in.
mohr::StressPoint stress_point(const ProbeState& state, const ui::DisplayUnits& units);

/// "rim: σx 12.3, σy −4, τxy 0, σ Mises 14.7", without units.
std::string text_of(const ProbeState::Beyond& beyond, const ui::DisplayUnits& units);

/// "12.3", with a true minus sign and without its unit.
std::string number_of(double value, ui::Measure measure, const ui::DisplayUnits& units);

} // namespace plane
