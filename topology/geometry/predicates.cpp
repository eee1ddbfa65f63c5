#include "topology/geometry/predicates.h"

#include <cmath>
#include <limits>
#include <vector>

namespace topology {

namespace {

constexpr double half_ulp = 0.5 * std::numeric_limits<double>::epsilon(); // 2^-53
constexpr double orientation_bound = (3.0 + 16.0 * half_ulp) * half_ulp;
constexpr double in_circle_bound = (10.0 + 96.0 * half_ulp) * half_ulp;

/// A number as the sum of doubles that do not overlap, the smallest first: without rounding.
class Expansion {
public:
    Expansion() = default;
    explicit Expansion(double value) { add(value); }

    /// The difference of two doubles.
    static Expansion difference(double a, double b)
    {
        Expansion result(a);
        result.add(-b);
        return result;
    }

    void add(double value)
    {
        std::vector<double> grown;
        grown.reserve(parts_.size() + 1);
        for (const double part : parts_) {
            const double sum = value + part, virtual_part = sum - value;
            const double rounding = (value - (sum - virtual_part)) + (part - virtual_part);
            if (rounding != 0.0) grown.push_back(rounding);
            value = sum;
        }
        if (value != 0.0) grown.push_back(value);
        parts_ = std::move(grown);
    }
    Expansion operator+(const Expansion& other) const
    {
        Expansion sum = *this;
        for (const double part : other.parts_) sum.add(part);
        return sum;
    }
    Expansion operator-() const
    {
        Expansion negative = *this;
        for (double& part : negative.parts_) part = -part;
        return negative;
    }
    Expansion operator-(const Expansion& other) const { return *this + -other; }
    Expansion operator*(const Expansion& other) const
    {
        Expansion product;
        for (const double a : parts_)
            for (const double b : other.parts_) {
                product.add(std::fma(a, b, -(a * b)));
                product.add(a * b);
            }
        return product;
    }
    double sign() const { return parts_.empty() ? 0.0 : parts_.back(); } ///< the largest part has it

private:
    std::vector<double> parts_;
};

/// A place from another, exactly.
struct ExactVector {
    Expansion x, y;

    ExactVector(const FlatPoint& from, const FlatPoint& to)
        : x(Expansion::difference(to.x, from.x)), y(Expansion::difference(to.y, from.y))
    {}
};

Expansion cross(const ExactVector& a, const ExactVector& b) { return a.x * b.y - a.y * b.x; }
Expansion square(const ExactVector& a) { return a.x * a.x + a.y * a.y; }

double exact_orientation(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c)
{
    return cross(ExactVector(c, a), ExactVector(c, b)).sign();
}

double exact_in_circle(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c, const FlatPoint& d)
{
    const ExactVector u(d, a), v(d, b), w(d, c);
    return (square(u) * cross(v, w) + square(v) * cross(w, u) + square(w) * cross(u, v)).sign();
}

} // namespace

double orientation(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c)
{
    const double left = (a.x - c.x) * (b.y - c.y), right = (a.y - c.y) * (b.x - c.x);
    const double value = left - right;
    const double bound = orientation_bound * (std::abs(left) + std::abs(right));
    return std::abs(value) > bound ? value : exact_orientation(a, b, c);
}

double in_circle(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c, const FlatPoint& d)
{
    const FlatVector u = a - d, v = b - d, w = c - d;
    const double uu = dot(u, u), vv = dot(v, v), ww = dot(w, w);
    const double vw = v.x * w.y, wv = v.y * w.x, wu = w.x * u.y, uw = w.y * u.x, uv = u.x * v.y, vu = u.y * v.x;
    const double value = uu * (vw - wv) + vv * (wu - uw) + ww * (uv - vu);
    const double size = uu * (std::abs(vw) + std::abs(wv)) + vv * (std::abs(wu) + std::abs(uw)) +
                        ww * (std::abs(uv) + std::abs(vu));
    return std::abs(value) > in_circle_bound * size ? value : exact_in_circle(a, b, c, d);
}

FlatPoint circumcentre(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c)
{
    const FlatVector u = b - a, v = c - a;
    const double scale = 0.5 / cross(u, v), uu = dot(u, u), vv = dot(v, v);
    return a + FlatVector{scale * (v.y * uu - u.y * vv), scale * (u.x * vv - v.x * uu)};
}

} // namespace topology
