#pragma once

namespace topology {

/// A place in space, in whatever unit of length the user thinks in. The kernel carries points for its vertices and
/// never looks at them.
struct Point {
    double x = 0.0, y = 0.0, z = 0.0;

    friend bool operator==(const Point&, const Point&) = default;
};

} // namespace topology
