#include "femoop/element/polynomial.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>

namespace femoop {

namespace {

constexpr double root_rounding = 64.0 * std::numeric_limits<double>::epsilon();

/// p(end s) for s in [0, 1], without leading terms that root_rounding alone left.
Polynomial on_unit_interval(const Polynomial& p, double end)
{
    std::array<double, Polynomial::max_terms> c{};
    double power = 1.0;
    double largest = 0.0;
    for (std::size_t i = 0; i < p.n_terms(); ++i, power *= end) {
        c[i] = p[i] * power;
        largest = std::max(largest, std::abs(c[i]));
    }
    std::size_t n = p.n_terms();
    while (n > 0 && std::abs(c[n - 1]) <= root_rounding * largest) --n;
    Polynomial scaled;
    for (std::size_t i = 0; i < n; ++i) scaled.append(c[i]);
    return scaled;
}

double magnitude(const Polynomial& p)
{
    double largest = 0.0;
    for (std::size_t i = 0; i < p.n_terms(); ++i) largest = std::max(largest, std::abs(p[i]));
    return largest;
}

/// The root between a and b, where p has opposite signs: bisection halves what secant steps leave.
double bracketed_root(const Polynomial& p, double a, double b)
{
    double fa = p(a);
    double fb = p(b);
    for (int step = 0; step < 200 && b - a > std::numeric_limits<double>::epsilon() * std::max(1e-3, b); ++step) {
        const double secant = a - fa * (b - a) / (fb - fa);
        const bool use_secant = step % 2 == 0 && secant > a && secant < b;
        const double x = use_secant ? secant : 0.5 * (a + b);
        const double fx = p(x);
        if (fx == 0.0) return x;
        if ((fx < 0.0) == (fa < 0.0)) {
            a = x;
            fa = fx;
        } else {
            b = x;
            fb = fx;
        }
    }
    return std::abs(fa) < std::abs(fb) ? a : b;
}

/// Roots in [0, 1]: between neighbouring extremes p is monotonic, so each interval holds one root at most.
std::vector<double> unit_roots(const Polynomial& p)
{
    if (p.n_terms() < 2) return {};
    const double tiny = root_rounding * magnitude(p);
    std::vector<double> places{0.0};
    if (p.n_terms() > 2)
        for (const double place : unit_roots(p.derivative())) places.push_back(place);
    places.push_back(1.0);

    std::vector<double> roots;
    const auto add = [&](double root) {
        if (roots.empty() || root - roots.back() > 1e-9) roots.push_back(root);
    };
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double here = p(places[i]);
        if (std::abs(here) <= tiny) {
            add(places[i]);
            continue;
        }
        if (i + 1 == places.size()) break;
        const double next = p(places[i + 1]);
        if (std::abs(next) > tiny && (here < 0.0) != (next < 0.0)) add(bracketed_root(p, places[i], places[i + 1]));
    }
    return roots;
}

} // namespace

Polynomial::Polynomial(std::initializer_list<double> coefficients)
{
    for (const double c : coefficients) append(c);
}

void Polynomial::append(double coefficient)
{
    if (n_ == max_terms) throw std::length_error("Polynomial: more terms than max_terms");
    c_[n_++] = coefficient;
}

Polynomial Polynomial::derivative() const
{
    Polynomial d;
    for (std::size_t i = 1; i < n_; ++i) d.append(static_cast<double>(i) * c_[i]);
    return d;
}

Polynomial Polynomial::shifted(double by) const
{
    Polynomial moved = *this;
    shift_coefficients(std::span(moved.c_).first(n_), by);
    return moved;
}

void shift_coefficients(std::span<double> coefficients, double by)
{
    if (by == 0.0) return;
    const std::size_t n = coefficients.size(); // divided by t - by again and again: the remainders are the coefficients
    for (std::size_t first = 0; first + 1 < n; ++first)
        for (std::size_t i = n - 1; i-- > first;) coefficients[i] += by * coefficients[i + 1];
}

Polynomial Polynomial::reciprocal() const
{
    const double inverse = 1.0 / c_[0];
    Polynomial r{inverse};
    for (std::size_t n = 1; n < max_terms; ++n) {
        double sum = 0.0;
        for (std::size_t k = 1; k < std::min(n_, n + 1); ++k) sum += c_[k] * r.c_[n - k];
        r.append(-inverse * sum);
    }
    return r;
}

double Polynomial::moment(std::size_t power, double end) const
{
    double sum = 0.0;
    for (std::size_t i = n_; i-- > 0;) sum = sum * end + c_[i] / static_cast<double>(i + power + 1);
    for (std::size_t i = 0; i <= power; ++i) sum *= end;
    return sum;
}

std::vector<double> Polynomial::roots(double end) const
{
    std::vector<double> found = unit_roots(on_unit_interval(*this, end));
    for (double& root : found) root *= end;
    return found;
}

} // namespace femoop
