#pragma once

#include <cstdint>

namespace femoop {

/// A place in an element, in its natural coordinates. A line uses xi alone.
struct NaturalPoint {
    double xi = 0.0, eta = 0.0;
};

/// What natural coordinates run over.
///
///      Line           xi from -1 to 1
///      Triangle       xi >= 0, eta >= 0, xi + eta <= 1: area coordinates L1 = 1 - xi - eta, L2 = xi, L3 = eta
///      Quadrilateral  xi and eta from -1 to 1
enum class Domain : std::uint8_t { Line, Triangle, Quadrilateral };

/// Length or area of the domain.
constexpr double measure(Domain domain)
{
    switch (domain) {
    case Domain::Line: return 2.0;
    case Domain::Triangle: return 0.5;
    case Domain::Quadrilateral: break;
    }
    return 4.0;
}

constexpr NaturalPoint centroid(Domain domain)
{
    return domain == Domain::Triangle ? NaturalPoint{.xi = 1.0 / 3.0, .eta = 1.0 / 3.0} : NaturalPoint{};
}

} // namespace femoop
