#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "femoop/model/ids.h"
#include "femoop/model/quantity/quantity.h"

namespace femoop::plane {

/// A place that a curve is drawn by: a point of the model, or its own x and y.
struct DrawnPlace {
    std::optional<NodeId> point;
    std::array<Quantity, 2> at; ///< where there is no point

    friend bool operator==(const DrawnPlace&, const DrawnPlace&) = default;
};

enum class DrawnKind : std::uint8_t {
    Line,    ///< straight parts one after the other
    Arc,     ///< of a circle, by three places, or by its centre and two ends
    Circle,  ///< counter-clockwise from its right end
    Ellipse, ///< the whole, or from one place to another
    Bezier,  ///< cubic pieces: ends and control points between them
    Spline   ///< natural or periodic cubic through its places
};

/// Into how many parts a piece of a curve is divided where a mesh is to be made.
struct Division {
    int n = 1;
    std::optional<Quantity> ratio; ///< of the last part to the first; equal parts when absent

    friend bool operator==(const Division&, const Division&) = default;
};

/// How a curve is drawn. Its pieces, and where they meet others, are not the model's but are found from it.
struct DrawnShape {
    DrawnKind kind = DrawnKind::Line;
    std::vector<DrawnPlace> places;
    bool is_closed = false;           ///< of a line or a spline
    std::optional<DrawnPlace> center; ///< of an arc, a circle or an ellipse
    std::optional<Quantity> radius;   ///< of a circle
    std::vector<Quantity> axes;       ///< of an ellipse: its half axes a and b
    std::optional<Quantity> angle;    ///< of an ellipse: of a, in degrees; 0 when absent
    std::optional<bool> is_clockwise; ///< of an arc with a centre and of an ellipse: counter-clockwise when absent
    std::vector<Division> divide;     ///< of every piece, or one of each; empty when absent
    bool is_divided_by_piece = false; ///< it was a list

    friend bool operator==(const DrawnShape&, const DrawnShape&) = default;
};

} // namespace femoop::plane
