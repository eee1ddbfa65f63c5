#pragma once

namespace femoop::cross {

/// The number with so many significant digits, as one writes it on paper; 0 digits keep it as it is.
double rounded(double value, int digits);

} // namespace femoop::cross
