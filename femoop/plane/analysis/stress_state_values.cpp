#include "femoop/plane/analysis/stress_state_values.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace femoop::plane {

namespace {

/// The unit vector from `about` to the place; along x at `about` itself.
Eigen::Vector2d radial(const Eigen::Vector2d& at, const Eigen::Vector2d& about)
{
    const double distance = (at - about).norm();
    return distance > 0.0 ? Eigen::Vector2d((at - about) / distance) : Eigen::Vector2d(1.0, 0.0);
}

} // namespace

PrincipalStress principal(const PlaneStress& s)
{
    const double mean = 0.5 * (s.sx + s.sy), radius = std::hypot(0.5 * (s.sx - s.sy), s.txy);
    PrincipalStress found{
        .s1 = mean + radius, .s2 = mean - radius, .angle = 0.5 * std::atan2(2.0 * s.txy, s.sx - s.sy)};
    if (found.angle <= -0.5 * std::numbers::pi) found.angle += std::numbers::pi;
    return found;
}

double von_mises(const PlaneStress& s)
{
    const double a = s.sx - s.sy, b = s.sy - s.sz, c = s.sz - s.sx;
    return std::sqrt(0.5 * (a * a + b * b + c * c) + 3.0 * s.txy * s.txy);
}

double tresca(const PlaneStress& s)
{
    const auto [s1, s2, angle] = principal(s);
    return std::max({s1, s2, s.sz}) - std::min({s1, s2, s.sz});
}

double component(const PlaneStress& s, PlaneComponent which, const Eigen::Vector2d& at, const Eigen::Vector2d& about)
{
    const Eigen::Vector2d n = radial(at, about);
    const double c = n.x(), si = n.y();
    switch (which) {
    case PlaneComponent::sx: return s.sx;
    case PlaneComponent::sy: return s.sy;
    case PlaneComponent::sz: return s.sz;
    case PlaneComponent::txy: return s.txy;
    case PlaneComponent::s1: return principal(s).s1;
    case PlaneComponent::s2: return principal(s).s2;
    case PlaneComponent::tmax: return 0.5 * (principal(s).s1 - principal(s).s2);
    case PlaneComponent::Mises: return von_mises(s);
    case PlaneComponent::Tresca: return tresca(s);
    case PlaneComponent::sr: return s.sx * c * c + s.sy * si * si + 2.0 * s.txy * c * si;
    case PlaneComponent::st: return s.sx * si * si + s.sy * c * c - 2.0 * s.txy * c * si;
    case PlaneComponent::trt: return (s.sy - s.sx) * c * si + s.txy * (c * c - si * si);
    default: throw std::logic_error("component: no stress");
    }
}

double component(const PlaneStrain& strain, PlaneComponent which)
{
    switch (which) {
    case PlaneComponent::ex: return strain.ex;
    case PlaneComponent::ey: return strain.ey;
    case PlaneComponent::ez: return strain.ez;
    case PlaneComponent::gxy: return strain.gxy;
    default: throw std::logic_error("component: no strain");
    }
}

double component(const Eigen::Vector2d& u, PlaneComponent which, const Eigen::Vector2d& at,
                 const Eigen::Vector2d& about)
{
    const Eigen::Vector2d n = radial(at, about);
    switch (which) {
    case PlaneComponent::ux: return u.x();
    case PlaneComponent::uy: return u.y();
    case PlaneComponent::ur: return u.dot(n);
    case PlaneComponent::ut: return u.dot(Eigen::Vector2d(-n.y(), n.x()));
    default: throw std::logic_error("component: no displacement");
    }
}

} // namespace femoop::plane
