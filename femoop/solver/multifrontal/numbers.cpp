#include "femoop/solver/multifrontal/numbers.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <algorithm>
#include <cstdint>

#include "femoop/solver/at_once.h"

namespace femoop {

namespace {

constexpr std::size_t worth_threads_to_return = std::size_t{1} << 23; // numbers
constexpr std::size_t provided_at_once = std::size_t{1} << 15;        // numbers

#ifdef __linux__
void return_pages(double* numbers, std::size_t n)
{
    constexpr std::size_t page = 1 << 16; // of every machine a whole number of pages
    constexpr std::size_t at_a_time = std::size_t{1} << 21;
    in_ranges(n, at_a_time, [&](std::size_t begin, std::size_t end) {
        auto* const first = reinterpret_cast<char*>(numbers + begin);
        const std::size_t to_page = (page - reinterpret_cast<std::uintptr_t>(first) % page) % page;
        const std::size_t beyond_page = reinterpret_cast<std::uintptr_t>(numbers + end) % page;
        const std::size_t bytes = (end - begin) * sizeof(double);
        if (to_page + beyond_page < bytes) madvise(first + to_page, bytes - to_page - beyond_page, MADV_DONTNEED);
    });
}

/// Whole pages, so that of others at both ends too: nothing that is written there changes. What the system refuses
/// comes when it is written.
void provide_pages(std::span<double> numbers)
{
#ifdef MADV_POPULATE_WRITE
    constexpr std::size_t page = 1 << 12;
    auto* const first = reinterpret_cast<char*>(numbers.data());
    const std::size_t before = reinterpret_cast<std::uintptr_t>(first) % page;
    static_cast<void>(madvise(first - before, before + numbers.size_bytes(), MADV_POPULATE_WRITE));
#else
    static_cast<void>(numbers);
#endif
}
#else
void provide_pages(std::span<double> /*numbers*/) {}
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

PagesAhead::PagesAhead(std::span<double> numbers)
    : missing_(numbers.size() < provided_at_once ? std::span<double>() : numbers)
{}

void PagesAhead::provide(const double* end)
{
    if (missing_.empty() || end <= missing_.data()) return;
    const std::size_t wanted = std::max(static_cast<std::size_t>(end - missing_.data()), provided_at_once);
    const std::size_t n = std::min(wanted, missing_.size());
    provide_pages(missing_.first(n));
    missing_ = missing_.subspan(n);
}

Numbers make_numbers(std::size_t n) { return {new double[n], ReturnPages{n}}; }

} // namespace femoop
