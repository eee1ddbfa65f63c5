#include "femoop/result/expression.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string_view>

namespace femoop {

namespace {

constexpr std::size_t most_terms_written = 6; // a solution without foundation has degree five at most
constexpr double expression_noise = 1e-11;    // of the largest term on the member
constexpr double series_noise = 1e-8; // a power series carries the round-off of the member's ends on through its terms

/// The same polynomial of x = t + begin.
std::vector<double> shifted(const Polynomial& p, double begin)
{
    std::vector<double> shifted(p.n_terms(), 0.0);
    for (std::size_t power = p.n_terms(); power-- > 0;) { // Horner's scheme with the polynomial x - begin
        for (std::size_t i = shifted.size(); i-- > 1;) shifted[i] = shifted[i - 1] - begin * shifted[i];
        if (!shifted.empty()) shifted[0] = p[power] - begin * shifted[0];
    }
    return shifted;
}

void drop_noise(Expression& of, double length)
{
    double largest = 0.0, power = 1.0;
    for (const double c : of.coefficients) {
        largest = std::max(largest, std::abs(c) * power);
        power *= length;
    }
    power = 1.0;
    for (double& c : of.coefficients) {
        if (std::abs(c) * power <= (of.is_series ? series_noise : expression_noise) * largest) c = 0.0;
        power *= length;
    }
    while (!of.coefficients.empty() && of.coefficients.back() == 0.0) of.coefficients.pop_back();
}

std::string_view power_text(std::size_t power)
{
    static constexpr std::array<std::string_view, most_terms_written> texts{"", " x", " x²", " x³", " x⁴", " x⁵"};
    return texts.at(power);
}

/// "3.5 x²", of the coefficient 1 "x²".
std::string term_text(double size, std::size_t power, int digits)
{
    std::ostringstream number;
    number.precision(digits);
    number << size;
    const std::string_view of_x = power_text(power);
    if (number.str() == "1" && power > 0) return std::string(of_x.substr(1));
    return number.str() + std::string(of_x);
}

} // namespace

Expression expression(const Polynomial& p, double from, double to, double length)
{
    Expression of{from, to, shifted(p, from), p.n_terms() > most_terms_written};
    drop_noise(of, length);
    return of;
}

bool go_on(const Expression& a, const Expression& b, double length)
{
    if (a.is_series || b.is_series) return false;
    const std::size_t n = std::max(a.coefficients.size(), b.coefficients.size());
    const auto at = [](const Expression& e, std::size_t i) {
        return i < e.coefficients.size() ? e.coefficients[i] : 0.0;
    };
    double largest = 0.0, apart = 0.0, power = 1.0;
    for (std::size_t i = 0; i < n; ++i) {
        largest = std::max({largest, std::abs(at(a, i)) * power, std::abs(at(b, i)) * power});
        apart = std::max(apart, std::abs(at(a, i) - at(b, i)) * power);
        power *= length;
    }
    return apart <= expression_noise * largest;
}

std::vector<Expression> expressions(const Curve& curve, MemberComponent component)
{
    const double length = curve.length();
    std::vector<Expression> all;
    for (const Curve::Piece& piece : curve.pieces()) {
        Expression next = expression(curve.polynomial(component, piece), piece.load.begin, piece.load.end, length);
        if (!all.empty() && go_on(all.back(), next, length)) all.back().to = next.to;
        else all.push_back(std::move(next));
    }
    return all;
}

std::string text(const Expression& expression, int digits)
{
    std::ostringstream line;
    const std::size_t n = std::min(expression.coefficients.size(), most_terms_written);
    for (std::size_t i = 0; i < n; ++i) {
        const double c = expression.coefficients[i];
        if (c == 0.0) continue;
        const bool is_first = line.tellp() == std::streampos(0);
        line << (is_first ? (c < 0.0 ? "-" : "") : (c < 0.0 ? " - " : " + ")) << term_text(std::abs(c), i, digits);
    }
    if (expression.is_series) line << " + …";
    return line.tellp() == std::streampos(0) ? "0" : line.str();
}

} // namespace femoop
