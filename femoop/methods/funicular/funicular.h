#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "femoop/methods/funicular/simple_span.h"

namespace femoop::funicular {

/// Heights of the closing line over the two ends of the span.
struct ClosingLine {
    double left = 0.0, right = 0.0;
};

/// The funicular of vertical loads over a closing line: the shape of a chain that carries them without bending.
///
///            .-'''-.                 y(x) = closing line(x) + M0(x) / H
///          .'  |f   '.
///         /    |      \  .- B        H > 0: an arch that thrusts, above its closing line under loads down
///        /   .-+--''''               H < 0: a cable that pulls, below it
///      A -''  closing line
///
/// An arch whose line of thrust it is has M = H e at a place of its axis, e the height of the line over that; its closing
/// line joins hinges at the ends. Another closing line leaves every ordinate M0 / H as it is.
///
/// Signs    forces positive down, H positive as thrust, M positive where it sags
/// Units    any consistent set
/// Assumes  vertical loads; nothing but loads acts between the ends
/// Accuracy exact
/// Source   [Culmann1866]; [TimoshenkoYoung1965, ch. 1]
struct Funicular {
    SimpleSpan span;
    ClosingLine closing_line;
    double H = 1.0;                      ///< not 0
    std::optional<double> led_through{}; ///< x of a point that gave H

    double closing(double x) const; ///< height of the closing line
    double ordinate(double x) const { return span.moment(x) / H; }
    double height(double x) const { return closing(x) + ordinate(x); }
    double rise() const { return span.largest_moment().value / H; } ///< f: the largest ordinate
};

/// The H of a funicular with this rise. \pre rise is not 0
double thrust_of_rise(const SimpleSpan& span, double rise);

/// The H of the funicular that passes through a point: H = M0 / f there. Nothing where the closing line passes through
/// it, or where M0 is 0, so that none does.
std::optional<double> thrust_through(const SimpleSpan& span, const ClosingLine& line, const Eigen::Vector2d& point);

/// The H of the funicular over the chord of a chain that passes through its crown; where none does, of a rise of a fifth
/// of the span.
double usual_thrust(const Chain& chain, const SimpleSpan& span);

/// Where the rise f is measured that gives H = M0 / f: one that is known before the funicular is.
struct GivenRise {
    enum class Place : std::uint8_t {
        Hinge,         ///< of the chain
        Point,         ///< another one that the funicular passes through: a given one, or the crown of the chain
        LargestMoment, ///< it passes through no such point, and its largest ordinate was chosen
    };
    Place place = Place::LargestMoment;
    double x = 0.0, M0 = 0.0, f = 0.0; ///< f over the closing line
};
GivenRise given_rise(const Funicular& funicular, const Chain& chain);

/// Whether the chain is a three-hinged arch and this, over its ends and through its hinge, the line of its thrust.
bool is_line_of_thrust(const Funicular& funicular, const Chain& chain);

/// The loads one after the other on the load line, and the pole: each ray is parallel to a side of the funicular polygon,
/// whose corners lie on the lines of the loads.
///
///                   . -| 0
///              . - '   |           levels fall by each load
///     pole O - - - - - | -R_A      the ray parallel to the closing line parts the load line into R_A and R_B
///              ' - .   |
///                   ' -| -sum      of a thrust the pole lies at the left, of a pull at the right
///            |<-- H -->|
///
/// Source  [Culmann1866]; [TimoshenkoYoung1965, ch. 1]
struct ForcePolygon {
    struct Load {
        double x = 0.0; ///< of its line; of a stretch that of its resultant
        double P = 0.0;
    };
    std::vector<Load> loads;                        ///< from left to right
    std::vector<double> levels;                     ///< as y of the load line, one more than loads; the first is 0
    Eigen::Vector2d pole = Eigen::Vector2d::Zero(); ///< the load line has x = 0
    double closing_level = 0.0;                     ///< -R_A

    /// Corners of the funicular polygon with its two ends, parallel to the rays in turn.
    std::vector<Eigen::Vector2d> corners(const Funicular& funicular) const;
};
ForcePolygon force_polygon(const Funicular& funicular);

} // namespace femoop::funicular
