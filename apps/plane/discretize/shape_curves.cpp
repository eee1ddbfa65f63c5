#include "apps/plane/discretize/shape_curves.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "femoop/model/quantity/number_text.h"

namespace discretize {

namespace {

using femoop::FaultKind;
using femoop::plane::DrawnKind;
using femoop::plane::DrawnShape;
using topology::FlatPoint;
using topology::FlatVector;

constexpr double pi = std::numbers::pi;
constexpr double radius_tolerance = 1e-6; // of a radius: ends of arcs may be rounded

/// Derivatives of the natural, or periodic, cubic spline at its places, by its parameter: the sum of chords.
/// [DeBoor1978, ch. IV, eq. (10) and (15)]
std::vector<FlatVector> slopes_of(const std::vector<FlatPoint>& places, const std::vector<double>& steps,
                                  bool is_periodic)
{
    const std::size_t n_steps = steps.size(), n = is_periodic ? n_steps : n_steps + 1;
    std::vector<Eigen::Triplet<double>> terms;
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(n), 2);
    for (std::size_t i = 0; i < n_steps; ++i) { // each step gives both its ends a share
        const auto a = static_cast<int>(i), b = static_cast<int>((i + 1) % n);
        const double h = steps[i];
        const FlatVector rise = (3.0 / (h * h)) * (places[(i + 1) % places.size()] - places[i]);
        for (const int end : {a, b}) {
            terms.emplace_back(end, end, 2.0 / h);
            right.row(end) += Eigen::RowVector2d(rise.x, rise.y);
        }
        terms.emplace_back(a, b, 1.0 / h);
        terms.emplace_back(b, a, 1.0 / h);
    }
    Eigen::SparseMatrix<double> K(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
    K.setFromTriplets(terms.begin(), terms.end());
    const Eigen::MatrixXd slopes = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(K).solve(right);
    std::vector<FlatVector> found;
    for (Eigen::Index i = 0; i < slopes.rows(); ++i) found.push_back({slopes(i, 0), slopes(i, 1)});
    return found;
}

/// Makes the parts of one curve.
class ShapeMaker {
public:
    ShapeMaker(const PlaneModel& model, const DrawnShape& shape, const std::string& place, double snap)
        : model_(model), shape_(shape), place_(place), snap_(snap)
    {
        for (const auto& each : shape.places) places_.push_back(place_of(model, each));
        if (shape.center) center_ = place_of(model, *shape.center);
    }

    ShapeCurves make()
    {
        switch (shape_.kind) {
        case DrawnKind::Line: make_line(); break;
        case DrawnKind::Arc: shape_.center ? make_arc_about_center() : make_arc_through_three(); break;
        case DrawnKind::Circle: make_circle(); break;
        case DrawnKind::Ellipse: make_ellipse(); break;
        case DrawnKind::Bezier: make_bezier(); break;
        case DrawnKind::Spline: make_spline(); break;
        }
        return std::move(made_);
    }

private:
    bool are_one(const FlatPoint& a, const FlatPoint& b) const { return distance(a, b) <= snap_; }
    void refuse(FaultKind kind, std::vector<std::string> details = {})
    {
        details.insert(details.begin(), place_);
        made_.faults.push_back({kind, std::move(details)});
        made_.parts.clear();
    }
    std::string length_text(double length) const
    {
        return femoop::number_text(length) + " " + std::string(femoop::name(model_.units.length));
    }

    void make_line()
    {
        std::vector<FlatPoint> corners = places_;
        if (shape_.is_closed && !are_one(corners.front(), corners.back())) corners.push_back(corners.front());
        for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
            if (are_one(corners[i], corners[i + 1])) return refuse(FaultKind::CurveWithoutLength);
            made_.parts.push_back({topology::Segment{corners[i], corners[i + 1]}, {corners[i], corners[i + 1]}});
        }
    }

    void add_arc(const topology::EllipticArc& arc, const FlatPoint& start, const FlatPoint& end)
    {
        made_.parts.push_back({arc, {start, end}});
    }

    /// From one angle to another, the way that is asked for: 0 to a whole turn.
    static double sweep_between(double from, double to, bool is_clockwise)
    {
        double sweep = std::remainder(to - from, 2.0 * pi);
        if (is_clockwise && sweep > 0.0) sweep -= 2.0 * pi;
        if (!is_clockwise && sweep < 0.0) sweep += 2.0 * pi;
        return sweep;
    }

    void make_arc_about_center()
    {
        const FlatVector a = places_[0] - center_, b = places_[1] - center_;
        const double r = length(a), s = length(b);
        if (are_one(places_[0], places_[1]) || r <= snap_ || s <= snap_) return refuse(FaultKind::CurveWithoutLength);
        if (std::abs(r - s) > std::max(snap_, radius_tolerance * std::max(r, s)))
            return refuse(FaultKind::ArcRadiiDiffer, {length_text(r), length_text(s)});
        const double start = std::atan2(a.y, a.x), end = std::atan2(b.y, b.x);
        add_arc({center_, {r, 0.0}, {0.0, r}, start, sweep_between(start, end, shape_.is_clockwise.value_or(false))},
                places_[0], places_[1]);
    }

    void make_arc_through_three()
    {
        const auto [a, b, c] = std::array{places_[0], places_[1], places_[2]};
        if (are_one(a, b) || are_one(b, c) || are_one(a, c)) return refuse(FaultKind::CurveWithoutLength);
        const FlatVector u = b - a, v = c - a;
        const double twice_area = cross(u, v), longest = std::max({distance(a, b), distance(b, c), distance(a, c)});
        if (std::abs(twice_area) <= snap_ * longest) return refuse(FaultKind::ArcPlacesInLine);
        const double uu = dot(u, u), vv = dot(v, v);
        const FlatVector to_center = 0.5 / twice_area * FlatVector{v.y * uu - u.y * vv, u.x * vv - v.x * uu};
        const FlatPoint center = a + to_center;
        const double r = length(to_center);
        const double start = std::atan2(a.y - center.y, a.x - center.x);
        const double end = std::atan2(c.y - center.y, c.x - center.x);
        add_arc({center, {r, 0.0}, {0.0, r}, start, sweep_between(start, end, twice_area < 0.0)}, a, c);
    }

    void make_circle()
    {
        const double r = *shape_.radius;
        if (r <= snap_) return refuse(FaultKind::CurveWithoutLength);
        const FlatPoint right{center_.x + r, center_.y};
        add_arc({center_, {r, 0.0}, {0.0, r}, 0.0, 2.0 * pi}, right, right);
    }

    void make_ellipse()
    {
        const double a = shape_.axes[0], b = shape_.axes[1];
        if (std::min(a, b) <= snap_) return refuse(FaultKind::CurveWithoutLength);
        const double turned = shape_.angle ? *shape_.angle * pi / 180.0 : 0.0;
        const FlatVector p{a * std::cos(turned), a * std::sin(turned)}, q{-b * std::sin(turned), b * std::cos(turned)};
        if (places_.empty()) return add_arc({center_, p, q, 0.0, 2.0 * pi}, center_ + p, center_ + p);
        if (are_one(places_[0], places_[1])) return refuse(FaultKind::CurveWithoutLength);
        const auto angle_of = [&](const FlatPoint& place) {
            const FlatVector d = place - center_;
            return std::atan2(dot(d, q) / (b * b), dot(d, p) / (a * a));
        };
        for (const FlatPoint& end : places_) {
            const double w = angle_of(end), off = distance(end, center_ + (std::cos(w) * p + std::sin(w) * q));
            if (off > std::max(snap_, radius_tolerance * std::max(a, b)))
                return refuse(FaultKind::EllipsePlaceOff, {length_text(off)});
        }
        const double start = angle_of(places_[0]), end = angle_of(places_[1]);
        add_arc({center_, p, q, start, sweep_between(start, end, shape_.is_clockwise.value_or(false))}, places_[0],
                places_[1]);
    }

    void add_cubic(const std::array<FlatPoint, 4>& points)
    {
        topology::FlatBox box;
        for (const FlatPoint& point : points) box.add(point);
        if (box.diagonal() <= snap_) return refuse(FaultKind::CurveWithoutLength);
        if (goes_back(points) && off_line(points) <= snap_) return refuse(FaultKind::CurveRunsBack);
        made_.parts.push_back({topology::CubicBezier{points}, {points[0], points[3]}});
    }

    /// How far the control points are from the line through the first and the one farthest from it.
    static double off_line(const std::array<FlatPoint, 4>& points)
    {
        FlatVector farthest{};
        for (const FlatPoint& point : points)
            if (const FlatVector there = point - points[0]; length(there) > length(farthest)) farthest = there;
        double off = 0.0;
        for (const FlatPoint& point : points) off = std::max(off, std::abs(cross(farthest, point - points[0])));
        return off / length(farthest);
    }

    /// Whether its speed along its chord turns: a Bernstein polynomial of degree 2 with these coefficients.
    bool goes_back(const std::array<FlatPoint, 4>& points) const
    {
        const FlatVector chord = points[3] - points[0];
        if (length(chord) <= snap_) return true;
        const double a = dot(points[1] - points[0], chord), b = dot(points[2] - points[1], chord),
                     c = dot(points[3] - points[2], chord), least = -1e-12 * dot(chord, chord);
        return a < least || c < least || b < least - std::sqrt(std::max(a, 0.0) * std::max(c, 0.0));
    }

    void make_bezier()
    {
        for (std::size_t i = 0; i + 3 < places_.size() && made_.faults.empty(); i += 3)
            add_cubic({places_[i], places_[i + 1], places_[i + 2], places_[i + 3]});
    }

    void make_spline()
    {
        std::vector<FlatPoint> places = places_;
        if (shape_.is_closed && are_one(places.front(), places.back())) places.pop_back();
        const std::size_t n_steps = shape_.is_closed ? places.size() : places.size() - 1;
        std::vector<double> steps;
        for (std::size_t i = 0; i < n_steps; ++i) {
            steps.push_back(distance(places[i], places[(i + 1) % places.size()]));
            if (steps.back() <= snap_) return refuse(FaultKind::CurveWithoutLength);
        }
        const std::vector<FlatVector> slopes = slopes_of(places, steps, shape_.is_closed);
        for (std::size_t i = 0; i < n_steps; ++i) {
            const std::size_t j = (i + 1) % places.size();
            add_cubic({places[i], places[i] + steps[i] / 3.0 * slopes[i],
                       places[j] + -steps[i] / 3.0 * slopes[j % slopes.size()], places[j]});
        }
    }

    const PlaneModel& model_;
    const DrawnShape& shape_;
    const std::string& place_;
    double snap_;
    std::vector<FlatPoint> places_;
    FlatPoint center_;
    ShapeCurves made_;
};

} // namespace

topology::FlatPoint place_of(const PlaneModel& model, const femoop::plane::DrawnPlace& drawn)
{
    const std::array<femoop::Quantity, 2>& at = drawn.point ? model[*drawn.point].at : drawn.at;
    return {at[0], at[1]};
}

ShapeCurves curves_of(const PlaneModel& model, const DrawnShape& shape, const std::string& place, double snap)
{
    return ShapeMaker(model, shape, place, snap).make();
}

} // namespace discretize
