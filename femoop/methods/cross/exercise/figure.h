#pragma once

namespace femoop::cross {

/// A number as a pupil has it: known as far as digits were written, and free of slips or not. What is worked out of
/// such numbers is no better known than they are.
struct Figure {
    double value = 0.0;
    double slack = 0.0;   ///< by how much it may be off for want of digits
    bool is_clean = true; ///< nothing wrong is behind it
};

Figure operator+(const Figure& a, const Figure& b);
Figure operator-(const Figure& a, const Figure& b);
Figure operator-(const Figure& a);
Figure operator*(const Figure& a, const Figure& b);
Figure operator*(double a, const Figure& b);
Figure operator/(const Figure& a, const Figure& b); ///< by nothing gives what is not finite

} // namespace femoop::cross
