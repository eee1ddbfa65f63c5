#include "femoop/rule/integration_rule.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace femoop {

namespace {

struct Legendre {
    double value, derivative;
};

/// P_n and its derivative, by k P_k = (2k - 1) x P_(k-1) - (k - 1) P_(k-2).
Legendre legendre(int n, double x)
{
    double p = 1.0, before = 0.0;
    for (int k = 1; k <= n; ++k) {
        const double next = ((2.0 * k - 1.0) * x * p - (k - 1.0) * before) / k;
        before = p;
        p = next;
    }
    return {.value = p, .derivative = n * (x * p - before) / (x * x - 1.0)};
}

/// The i-th root of P_n from above, by Newton from Chebyshev's place.
double legendre_root(int n, int i)
{
    double x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
    for (int step = 0; step < 20; ++step) {
        const Legendre p = legendre(n, x);
        const double correction = p.value / p.derivative;
        x -= correction;
        if (std::abs(correction) < std::numeric_limits<double>::epsilon()) break;
    }
    return x;
}

constexpr double triangle_area = measure(Domain::Triangle);

void add_centroid(IntegrationRule& rule, double share)
{
    rule.points.push_back({.at = centroid(Domain::Triangle), .weight = share * triangle_area});
}

/// Three points with two area coordinates equal to a; each weighs this share of the area.
void add_orbit(IntegrationRule& rule, double a, double share)
{
    const double weight = share * triangle_area;
    rule.points.push_back({.at = {.xi = a, .eta = a}, .weight = weight});
    rule.points.push_back({.at = {.xi = 1.0 - 2.0 * a, .eta = a}, .weight = weight});
    rule.points.push_back({.at = {.xi = a, .eta = 1.0 - 2.0 * a}, .weight = weight});
}

} // namespace

IntegrationRule gauss_line(int n)
{
    IntegrationRule rule{.domain = Domain::Line, .degree = 2 * n - 1, .points = {}};
    for (int i = n - 1; i >= 0; --i) {
        const bool is_middle = 2 * i + 1 == n;
        const double x = is_middle ? 0.0 : legendre_root(n, i);
        const double slope = legendre(n, x).derivative;
        rule.points.push_back({.at = {.xi = x}, .weight = 2.0 / ((1.0 - x * x) * slope * slope)});
    }
    return rule;
}

IntegrationRule gauss_quadrilateral(int n)
{
    const IntegrationRule line = gauss_line(n);
    IntegrationRule rule{.domain = Domain::Quadrilateral, .degree = line.degree, .points = {}};
    for (const IntegrationPoint& b : line.points)
        for (const IntegrationPoint& a : line.points)
            rule.points.push_back({.at = {.xi = a.at.xi, .eta = b.at.xi}, .weight = a.weight * b.weight});
    return rule;
}

IntegrationRule symmetric_triangle(int n_points)
{
    IntegrationRule rule{.domain = Domain::Triangle, .degree = 1, .points = {}};
    const double root10 = std::sqrt(10.0), root15 = std::sqrt(15.0);
    switch (n_points) {
    case 1: add_centroid(rule, 1.0); return rule;
    case 3:
        rule.degree = 2;
        add_orbit(rule, 1.0 / 6.0, 1.0 / 3.0);
        return rule;
    case 6:
        rule.degree = 4;
        for (const double sign : {1.0, -1.0})
            add_orbit(rule, (8.0 - root10 + sign * std::sqrt(38.0 - 44.0 * std::sqrt(0.4))) / 18.0,
                      (620.0 + sign * std::sqrt(213125.0 - 53320.0 * root10)) / 3720.0);
        return rule;
    case 7:
        rule.degree = 5;
        add_centroid(rule, 9.0 / 40.0);
        for (const double sign : {1.0, -1.0})
            add_orbit(rule, (6.0 + sign * root15) / 21.0, (155.0 + sign * root15) / 1200.0);
        return rule;
    default: throw std::invalid_argument("symmetric_triangle: only rules of 1, 3, 6 and 7 points");
    }
}

IntegrationRule collapsed_triangle(int n)
{
    IntegrationRule rule{.domain = Domain::Triangle, .degree = 2 * n - 2, .points = {}};
    for (const IntegrationPoint& point : gauss_quadrilateral(n).points) {
        const double u = 0.5 * (1.0 + point.at.xi), v = 0.5 * (1.0 + point.at.eta);
        rule.points.push_back({.at = {.xi = u, .eta = (1.0 - u) * v}, .weight = 0.25 * (1.0 - u) * point.weight});
    }
    return rule;
}

IntegrationRule rule_of_degree(Domain domain, int degree)
{
    const int n = std::max(degree, 0) / 2 + 1;
    if (domain == Domain::Line) return gauss_line(n);
    if (domain == Domain::Quadrilateral) return gauss_quadrilateral(n);
    constexpr std::array n_points{1, 1, 3, 6, 6, 7}; // by degree
    if (degree < static_cast<int>(n_points.size()))
        return symmetric_triangle(n_points[static_cast<std::size_t>(std::max(degree, 0))]);
    return collapsed_triangle((degree + 3) / 2);
}

} // namespace femoop
