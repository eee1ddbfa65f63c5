#pragma once

#include <cmath>

#include "topology/geometry/point.h"

namespace topology {

/// A difference of points.
struct Vector {
    double x = 0.0, y = 0.0, z = 0.0;

    friend bool operator==(const Vector&, const Vector&) = default;
};

inline Vector operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Point operator+(const Point& p, const Vector& a) { return {p.x + a.x, p.y + a.y, p.z + a.z}; }
inline Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vector operator*(double k, const Vector& a) { return {k * a.x, k * a.y, k * a.z}; }
inline double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector cross(const Vector& a, const Vector& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(const Vector& a) { return std::sqrt(dot(a, a)); }
inline bool is_finite(const Point& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

} // namespace topology
