#include "femoop/methods/mohr/space_state.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

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

SpacePrincipal in_order(const Eigen::Matrix3d& A, const Eigen::Matrix3d& V, int power)
{
    std::array<int, 3> order{0, 1, 2};
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return A(a, a) > A(b, b); });
    SpacePrincipal result;
    for (int i = 0; i < 3; ++i) {
        result.values[i] = std::ldexp(A(order[i], order[i]), power) + 0.0;
        result.directions.col(i) = V.col(order[i]).normalized();
    }
    make_largest_positive(result.directions.col(0));
    make_largest_positive(result.directions.col(1));
    result.directions.col(2) = result.directions.col(0).cross(result.directions.col(1)).normalized();
    return result;
}

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
    return in_order(A, V, power);
}

SpaceState from_principal(const SpacePrincipal& principal)
{
    const Eigen::Vector3d values(principal.values[0], principal.values[1], principal.values[2]);
    return from_tensor(principal.directions * values.asDiagonal() * principal.directions.transpose());
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
        return Circle{0.5 * first + 0.5 * second, 0.5 * first - 0.5 * second};
    };
    return {between(0, 2), between(0, 1), between(1, 2)};
}

double absolute_largest_shear(const SpacePrincipal& principal)
{
    return 0.5 * principal.values[0] - 0.5 * principal.values[2];
}

Invariants invariants(const SpaceState& s)
{
    return {s.x + s.y + s.z, s.x * s.y + s.y * s.z + s.z * s.x - s.xy * s.xy - s.yz * s.yz - s.zx * s.zx,
            s.x * (s.y * s.z - s.yz * s.yz) - s.xy * (s.xy * s.z - s.yz * s.zx) + s.zx * (s.xy * s.yz - s.y * s.zx)};
}

Deviator deviator(const SpacePrincipal& principal)
{
    const auto& s = principal.values;
    Deviator d;
    d.mean = s[0] / 3.0 + s[1] / 3.0 + s[2] / 3.0;
    // Differences of principal values, so that a deviator small beside its mean keeps its digits.
    const double a = s[0] - s[1], b = s[1] - s[2], c = s[0] - s[2];
    d.values = {(a + c) / 3.0, (b - a) / 3.0, -(b + c) / 3.0};
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
    result.traction = tensor(state) * result.normal;
    result.normal_component = result.normal.dot(result.traction);
    const Eigen::Vector3d in_plane = result.traction - result.normal_component * result.normal;
    result.shear = in_plane.stableNorm();
    const double rounding = 8.0 * std::numeric_limits<double>::epsilon() * tensor(state).cwiseAbs().maxCoeff();
    if (result.shear <= rounding) result.shear = 0.0;
    else result.shear_direction = in_plane / result.shear;
    return result;
}

} // namespace femoop::mohr
