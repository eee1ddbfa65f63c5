#pragma once

#include <cstdint>
#include <vector>

#include "femoop/shape/natural_point.h"

namespace femoop {

struct IntegrationPoint {
    NaturalPoint at;
    double weight = 0.0;
};

/// Integrates over an element's natural coordinates: the sum of weight x value at points inside replaces the integral.
///
/// Accuracy exact for polynomials of `degree`; of a quadrilateral in each of xi and eta, else in both together
/// Source   [MarthaParente2002]: the class IntegrationRule
struct IntegrationRule {
    Domain domain = Domain::Line;
    int degree = 0;
    std::vector<IntegrationPoint> points;
};

/// Gauss and Legendre's n points on a line, ascending: degree 2n - 1. \pre n >= 1
IntegrationRule gauss_line(int n);

/// Their product with themselves, n x n points: first all along xi at the least eta. \pre n >= 1
IntegrationRule gauss_quadrilateral(int n);

/// Symmetric rules of a triangle, all points inside and all weights positive: 1 point of degree 1, 3 of 2, 6 of 4, 7 of
/// 5.
/// Source  [Dunavant1985]; here in closed form
/// \throws std::invalid_argument for another number of points
IntegrationRule symmetric_triangle(int n_points);

/// The square of n x n points with one side drawn together to a corner: degree 2n - 2. \pre n >= 1
///
///      xi = u, eta = (1 - u) v, u and v from 0 to 1        dxi deta = (1 - u) du dv
IntegrationRule collapsed_triangle(int n);

/// The rule with the fewest points of these that is exact up to a degree.
IntegrationRule rule_of_degree(Domain domain, int degree);

} // namespace femoop
