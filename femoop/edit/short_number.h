#pragma once

namespace femoop {

/// The number of the fewest decimals that is `value` but for a few roundings of calculations with numbers as large as
/// `scale`: 3 for 3.0000000000000018, 50 for 49.99999999999998. The value itself where no number of at most twelve
/// digits is so near: thirds stay thirds.
double short_number(double value, double scale);

} // namespace femoop
