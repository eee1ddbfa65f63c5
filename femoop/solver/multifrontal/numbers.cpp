#include "femoop/solver/multifrontal/numbers.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <cstdint>

#include "femoop/solver/at_once.h"

namespace femoop {

namespace {

constexpr std::size_t worth_threads_to_return = std::size_t{1} << 23; // numbers

#ifdef __linux__
void return_pages(double* numbers, std::size_t n)
{
    constexpr std::uintptr_t page = 1 << 16; // of every machine a whole number of pages
    constexpr std::size_t at_a_time = std::size_t{1} << 21;
    in_ranges(n, at_a_time, [&](std::size_t begin, std::size_t end) {
        const auto first = (reinterpret_cast<std::uintptr_t>(numbers + begin) + page - 1) / page * page;
        const auto last = reinterpret_cast<std::uintptr_t>(numbers + end) / page * page;
        if (first < last) madvise(reinterpret_cast<void*>(first), last - first, MADV_DONTNEED);
    });
}
#else
void return_pages(double* /*numbers*/, std::size_t /*n*/) {}
#endif

} // namespace

void ReturnPages::operator()(double* numbers) const noexcept
{
    try {
        if (n >= worth_threads_to_return) return_pages(numbers, n);
    } catch (...) { // without threads they go back below
    }
    delete[] numbers;
}

Numbers make_numbers(std::size_t n) { return {new double[n], ReturnPages{n}}; }

} // namespace femoop
