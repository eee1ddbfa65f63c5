#include "femoop/methods/mohr/space_state.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "femoop/methods/mohr/rounding.h"

namespace femoop::mohr {

namespace {

/// Turns rows and columns p, q so that the component pq becomes 0; `V` gathers the turns.
void annihilate(Eigen::Matrix3d& A, Eigen::Matrix3d& V, int p, int q)
{
    const double apq = A(p, q);
    if (apq == 0.0) return;
    const double tau = (A(q, q) - A(p, p)) / (2.0 * apq);
    const double t = std::isfinite(tau) ? (tau >= 0.0 ? 1.0 : -1.0) / (std::abs(tau) + std::hypot(1.0, tau)) : 0.0;
    const double c = 1.0 / std::hypot(1.0, t);
    const double s = t * c;
    const int r = 3 - p - q;
    A(p, p) -= t * apq;
    A(q, q) += t * apq;
    A(p, q) = A(q, p) = 0.0;
    const double arp = A(r, p);
    A(r, p) = A(p, r) = c * arp - s * A(r, q);
    A(r, q) = A(q, r) = s * arp + c * A(r, q);
    const Eigen::Vector3d vp = V.col(p);
    V.col(p) = c * vp - s * V.col(q);
    V.col(q) = s * vp + c * V.col(q);
}

double off_diagonal(const Eigen::Matrix3d& A)
{
    return std::max({std::abs(A(0, 1)), std::abs(A(1, 2)), std::abs(A(2, 0))});
}

void make_largest_positive(Eigen::Ref<Eigen::Vector3d> direction)
{
    Eigen::Index largest = 0;
    direction.cwiseAbs().maxCoeff(&largest);
    if (direction[largest] < 0.0) direction = -direction;
}

/// A unit vector; what is rounding beside its length is 0.
Eigen::Vector3d unit(const Eigen::Vector3d& v)
{
    return v.normalized().unaryExpr([](double part) { return without_rounding(part, 1.0) + 0.0; });
}

/// A principal direction along an axis has the component of that axis, to the last digit.
double principal_value(const Eigen::Matrix3d& A, const Eigen::Matrix3d& V, int i)
{
    const bool is_untouched = V.col(i).cwiseAbs().maxCoeff() == 1.0;
    return is_untouched ? A(i, i) : without_rounding(A(i, i), A.cwiseAbs().maxCoeff());
}

SpacePrincipal in_order(const Eigen::Matrix3d& A, const Eigen::Matrix3d& V, int power)
{
    std::array<int, 3> order{0, 1, 2};
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return A(a, a) > A(b, b); });
    SpacePrincipal result;
    for (int i = 0; i < 3; ++i) {
        result.values[i] = std::ldexp(principal_value(A, V, order[i]), power) + 0.0;
        result.directions.col(i) = unit(V.col(order[i]));
    }
    make_largest_positive(result.directions.col(0));
    make_largest_positive(result.directions.col(1));
    result.directions.col(2) = unit(result.directions.col(0).cross(result.directions.col(1)));
    return result;
}

/// Of a state with a principal direction z: to a few roundings each, as `principal` of the plane state.
std::array<double, 3> values_of_plane(const SpaceState& state)
{
    const PlanePrincipal plane = principal(PlaneState{state.x, state.y, state.xy});
    std::array<double, 3> values{plane.first, plane.second, state.z + 0.0};
    std::ranges::sort(values, std::greater{});
    return values;
}

/// What two principal values differ by.
double difference(double larger, double smaller) { return sum_of({larger, -smaller}); }

} // namespace

Eigen::Matrix3d tensor(const SpaceState& s)
{
    return (Eigen::Matrix3d() << s.x, s.xy, s.zx, s.xy, s.y, s.yz, s.zx, s.yz, s.z).finished();
}

SpaceState from_tensor(const Eigen::Matrix3d& T)
{
    return {.x = T(0, 0), .y = T(1, 1), .z = T(2, 2), .xy = T(0, 1), .yz = T(1, 2), .zx = T(2, 0)};
}

SpaceState in_space(const PlaneState& plane, double third)
{
    return {.x = plane.x, .y = plane.y, .z = third, .xy = plane.xy};
}

SpacePrincipal principal(const SpaceState& state)
{
    Eigen::Matrix3d A = tensor(state);
    int power = 0;
    static_cast<void>(std::frexp(A.cwiseAbs().maxCoeff(), &power)); // products of numbers near 1 keep their digits
    A = A.unaryExpr([&](double a) { return std::ldexp(a, -power); });
    Eigen::Matrix3d V = Eigen::Matrix3d::Identity();
    constexpr int most_sweeps = 20; // convergence is quadratic: five do for any tensor that was ever met
    for (int sweep = 0; sweep < most_sweeps && off_diagonal(A) > std::numeric_limits<double>::min(); ++sweep)
        for (const auto& [p, q] : {std::pair{0, 1}, {0, 2}, {1, 2}}) annihilate(A, V, p, q);
    SpacePrincipal result = in_order(A, V, power);
    if (state.yz == 0.0 && state.zx == 0.0) result.values = values_of_plane(state);
    return result;
}

SpaceState from_principal(const SpacePrincipal& principal)
{
    const Eigen::Vector3d values(principal.values[0], principal.values[1], principal.values[2]);
    const Eigen::Matrix3d T = principal.directions * values.asDiagonal() * principal.directions.transpose();
    const double largest = values.cwiseAbs().maxCoeff();
    return from_tensor(T.unaryExpr([&](double part) { return without_rounding(part, largest); }));
}

SpacePrincipal with_direction(const SpacePrincipal& principal, int direction, const Eigen::Vector3d& along)
{
    const int next = (direction + 1) % 3, last = (direction + 2) % 3;
    const Eigen::Vector3d first = along.stableNormalized();
    Eigen::Vector3d second = principal.directions.col(next) - first.dot(principal.directions.col(next)) * first;
    if (second.norm() < 1e-6) second = principal.directions.col(last).cross(first);
    SpacePrincipal result = principal;
    result.directions.col(direction) = first;
    result.directions.col(next) = second.normalized();
    result.directions.col(last) = first.cross(second.normalized());
    return result;
}

std::array<Circle, 3> circles(const SpacePrincipal& principal)
{
    const auto between = [&](int a, int b) {
        const double first = principal.values[a], second = principal.values[b];
        return Circle{sum_of({0.5 * first, 0.5 * second}), 0.5 * difference(first, second)};
    };
    return {between(0, 2), between(0, 1), between(1, 2)};
}

double absolute_largest_shear(const SpacePrincipal& principal) { return circles(principal)[0].radius; }

Invariants invariants(const SpaceState& s)
{
    return {sum_of({s.x, s.y, s.z}),
            sum_of({s.x * s.y, s.y * s.z, s.z * s.x, -s.xy * s.xy, -s.yz * s.yz, -s.zx * s.zx}),
            sum_of({s.x * s.y * s.z, -s.x * s.yz * s.yz, -s.y * s.zx * s.zx, -s.z * s.xy * s.xy,
                    2.0 * s.xy * s.yz * s.zx})};
}

Deviator deviator(const SpacePrincipal& principal)
{
    const auto& s = principal.values;
    Deviator d;
    d.mean = sum_of({s[0] / 3.0, s[1] / 3.0, s[2] / 3.0});
    // Differences of principal values, so that a deviator small beside its mean keeps its digits.
    const double a = difference(s[0], s[1]), b = difference(s[1], s[2]), c = difference(s[0], s[2]);
    const double largest = std::max(std::abs(s[0]), std::abs(s[2]));
    d.values = {(a + c) / 3.0, without_rounding(b - a, largest) / 3.0, -(b + c) / 3.0};
    const double size = std::hypot(a, b, c);
    d.octahedral_shear = size / 3.0;
    d.equivalent = size / std::numbers::sqrt2;
    d.J2 = size * size / 6.0;
    d.J3 = d.values[0] * d.values[1] * d.values[2];
    if (c > 0.0) d.lode = std::atan2(std::numbers::sqrt3 * b, a + c);
    return d;
}

OnPlane on_plane(const SpaceState& state, const Eigen::Vector3d& normal)
{
    OnPlane result;
    result.normal = normal.stableNormalized();
    const Eigen::Matrix3d parts = tensor(state) * result.normal.asDiagonal();
    for (int i = 0; i < 3; ++i) result.traction[i] = sum_of({parts(i, 0), parts(i, 1), parts(i, 2)});
    const Eigen::Vector3d along = result.normal.cwiseProduct(result.traction);
    result.normal_component = sum_of({along[0], along[1], along[2]});
    const Eigen::Vector3d in_plane = result.traction - result.normal_component * result.normal;
    result.shear = in_plane.stableNorm();
    result.shear = without_rounding(result.shear, tensor(state).cwiseAbs().maxCoeff());
    if (result.shear > 0.0) result.shear_direction = in_plane / result.shear;
    return result;
}

} // namespace femoop::mohr
