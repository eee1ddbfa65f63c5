#include "femoop/methods/cross/exercise/figure.h"

#include <cmath>

namespace femoop::cross {

Figure operator+(const Figure& a, const Figure& b)
{
    return {a.value + b.value, a.slack + b.slack, a.is_clean && b.is_clean};
}

Figure operator-(const Figure& a) { return {-a.value, a.slack, a.is_clean}; }

Figure operator-(const Figure& a, const Figure& b) { return a + -b; }

Figure operator*(const Figure& a, const Figure& b)
{
    return {a.value * b.value, std::abs(a.value) * b.slack + std::abs(b.value) * a.slack, a.is_clean && b.is_clean};
}

Figure operator*(double a, const Figure& b) { return {a * b.value, std::abs(a) * b.slack, b.is_clean}; }

Figure operator/(const Figure& a, const Figure& b)
{
    const double value = a.value / b.value;
    return {value, (a.slack + std::abs(value) * b.slack) / std::abs(b.value), a.is_clean && b.is_clean};
}

} // namespace femoop::cross
