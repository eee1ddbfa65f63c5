#pragma once

#include <cstddef>
#include <memory>

namespace femoop {

/// Gives many pages back to the system by several threads at a time, which takes one of them as long as a tenth of a
/// factorization.
struct ReturnPages {
    std::size_t n = 0; ///< numbers
    void operator()(double* numbers) const noexcept;
};

/// Undefined at first.
using Numbers = std::unique_ptr<double[], ReturnPages>;
Numbers make_numbers(std::size_t n);

} // namespace femoop
