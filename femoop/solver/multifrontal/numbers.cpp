#include "femoop/solver/multifrontal/numbers.h"

#include <cstdlib>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace femoop {

namespace {

constexpr std::size_t cache_line = 64;
constexpr std::size_t large_page = std::size_t{2} << 20;

constexpr std::size_t rounded_up(std::size_t bytes, std::size_t unit) { return (bytes + unit - 1) / unit * unit; }

} // namespace

void FreeNumbers::operator()(double* numbers) const { std::free(numbers); }

Numbers make_numbers(std::size_t n)
{
    const bool is_large = n * sizeof(double) >= 2 * large_page;
    const std::size_t unit = is_large ? large_page : cache_line;
    const std::size_t bytes = rounded_up(n * sizeof(double) + 1, unit);
    void* const memory = std::aligned_alloc(unit, bytes);
    if (memory == nullptr) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
    if (is_large) static_cast<void>(madvise(memory, bytes, MADV_HUGEPAGE)); // a wish
#endif
    return Numbers(static_cast<double*>(memory));
}

} // namespace femoop
