#pragma once

#include <cstddef>
#include <functional>

namespace femoop {

/// Two works at the same time, which must not touch each other's data; one after the other where there are no threads.
/// The first exception comes out when both have ended.
void at_once(const std::function<void()>& first, const std::function<void()>& second);

/// Work on the numbers begin .. end - 1.
using RangeWork = std::function<void(std::size_t begin, std::size_t end)>;

/// Does 0 .. n - 1 in ranges of `length` numbers, on as many threads as the machine has processors. The ranges do not
/// depend on the threads, and what a range computes must not either.
void in_ranges(std::size_t n, std::size_t length, const RangeWork& work);

} // namespace femoop
