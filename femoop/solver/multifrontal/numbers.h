#pragma once

#include <cstddef>
#include <memory>
#include <span>

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

/// Asks the system for the pages of numbers shortly before they are first written: some dozens at a time cost a sixth
/// less than one by one, and are still in the cache then.
class PagesAhead {
public:
    /// \param numbers  written from the first to the last
    explicit PagesAhead(std::span<double> numbers);
    void provide(const double* end); ///< those before `end`, and some more

private:
    std::span<double> missing_;
};

} // namespace femoop
