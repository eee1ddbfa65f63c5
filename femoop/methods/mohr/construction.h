#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "femoop/methods/mohr/plane_state.h"

namespace femoop::mohr {

/// How Mohr's circle is drawn with compass and ruler, in the order of a blackboard. All places are in the diagram of
/// ShearRule::ClockwiseUp, normal component to the right and shear up; ShearRule::TensorDown has the same picture, with
/// the shear counted downwards.
enum class ConstructionStage : std::uint8_t {
    Axes,            ///< the two axes at one scale
    FaceX,           ///< the point X of the face x
    FaceY,           ///< the point Y of the face y
    Diameter,        ///< X and Y are joined; the line meets the normal axis in C
    Circle,          ///< the compass in C, opened to X
    PrincipalValues, ///< the circle meets the normal axis
    LargestShear,    ///< its highest and its lowest point
    Pole,            ///< through X a line parallel to the face x; where it meets the circle again is the pole P
    PrincipalPlanes, ///< from P to both principal points: lines parallel to the planes on which these values act
    Plane,           ///< from P a line parallel to the plane that is looked at; it meets the circle in N
    Point,           ///< instead of all from Diameter on: X and Y are one point, and the circle is it

    ThreeValues,   ///< in space (space_construction.h): the principal values on the axis
    LargestCircle, ///< over the first and the third
    UpperCircle,   ///< over the first and the second
    LowerCircle,   ///< over the second and the third; every plane's point lies between the three
    SpaceShear,    ///< the highest point of the largest circle
    FromFirst,     ///< from the first value a line at the normal's angle with direction 1, and the arc of that angle
    FromThird,     ///< likewise from the third
    ArcsMeet       ///< both arcs meet in the plane's point N
};

enum class ConstructionMark : std::uint8_t { X, Y, C, First, Second, Top, Bottom, P, N, Third, Helper };

/// What a step adds to the sheet.
struct ConstructionStep {
    struct Point {
        ConstructionMark mark;
        CirclePoint at;
    };
    struct Line {
        CirclePoint from, to;
    };
    struct Arc {
        CirclePoint centre;
        double radius = 0.0, start = 0.0, sweep = 0.0; ///< angles in rad, counter-clockwise
    };

    ConstructionStage stage = ConstructionStage::Axes;
    std::vector<Point> points{};
    std::vector<Line> lines{}; ///< drawn with the ruler
    std::vector<Arc> arcs{};   ///< drawn with the compass, whose point stands in the centre
};

/// \param angle  from x to the normal of the plane that is looked at [rad]
/// Source  [Mohr1882]; the pole (origin of planes) as in soil mechanics [TerzaghiPeck]
std::vector<ConstructionStep> construction(const PlaneState& state, double angle);

} // namespace femoop::mohr
