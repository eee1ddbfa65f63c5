#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace topology {

/// A place in a plane, by its two coordinates there.
struct FlatPoint {
    double x = 0.0, y = 0.0;

    friend bool operator==(const FlatPoint&, const FlatPoint&) = default;
};

/// A difference of such places.
struct FlatVector {
    double x = 0.0, y = 0.0;

    friend bool operator==(const FlatVector&, const FlatVector&) = default;
};

inline FlatVector operator-(const FlatPoint& a, const FlatPoint& b) { return {a.x - b.x, a.y - b.y}; }
inline FlatPoint operator+(const FlatPoint& p, const FlatVector& a) { return {p.x + a.x, p.y + a.y}; }
inline FlatVector operator+(const FlatVector& a, const FlatVector& b) { return {a.x + b.x, a.y + b.y}; }
inline FlatVector operator-(const FlatVector& a, const FlatVector& b) { return {a.x - b.x, a.y - b.y}; }
inline FlatVector operator-(const FlatVector& a) { return {-a.x, -a.y}; }
inline FlatVector operator*(double k, const FlatVector& a) { return {k * a.x, k * a.y}; }
inline double dot(const FlatVector& a, const FlatVector& b) { return a.x * b.x + a.y * b.y; }
/// Positive where b lies counter-clockwise of a.
inline double cross(const FlatVector& a, const FlatVector& b) { return a.x * b.y - a.y * b.x; }
inline double length(const FlatVector& a) { return std::sqrt(dot(a, a)); }
inline double distance(const FlatPoint& a, const FlatPoint& b) { return length(a - b); }
inline FlatPoint middle(const FlatPoint& a, const FlatPoint& b) { return a + 0.5 * (b - a); }

/// Twice the area of the triangle a b c, positive where it is counter-clockwise.
inline double turn(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c) { return cross(b - a, c - a); }

/// A rectangle along the axes; without any point to begin with.
struct FlatBox {
    FlatPoint low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    FlatPoint high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

    void add(const FlatPoint& p)
    {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    FlatBox grown(double by) const { return {{low.x - by, low.y - by}, {high.x + by, high.y + by}}; }
    bool is_empty() const { return !(low.x <= high.x); }
    bool has(const FlatPoint& p) const { return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y; }
    bool meets(const FlatBox& other) const
    {
        return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y && other.low.y <= high.y;
    }
    double diagonal() const { return is_empty() ? 0.0 : distance(low, high); }
};

} // namespace topology
