#pragma once

#include <cstddef>
#include <memory>

namespace femoop {

struct FreeNumbers {
    void operator()(double* numbers) const;
};
/// An array of numbers, in the largest pages that the system gives where it is large: to write to it for the first time
/// costs a fault for each page.
using Numbers = std::unique_ptr<double[], FreeNumbers>;

/// Not set to anything. \throws std::bad_alloc
Numbers make_numbers(std::size_t n);

} // namespace femoop
