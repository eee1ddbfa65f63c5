#pragma once

#include <array>
#include <optional>
#include <span>

#include "apps/mohr/exercise/exercise.h"

namespace mohr {

/// An answer to everything that can be asked, by its place in Asked: what later ones build on.
class Numbers {
public:
    double operator[](Asked asked) const { return values_[static_cast<std::size_t>(asked)]; }
    double& operator[](Asked asked) { return values_[static_cast<std::size_t>(asked)]; }

private:
    std::array<double, n_asked> values_{};
};

/// The answer by the right operation on the numbers before it.
double answer_from(Asked asked, const Exercise& exercise, const Numbers& before);

Numbers right_numbers(const Exercise& exercise);
/// What a pupil has: the own answers, and what follows from them by the right operation.
Numbers own_numbers(const Exercise& exercise, std::span<const std::optional<double>> answers);

/// The right answer.
double solution_of(Asked asked, const Exercise& exercise);

/// What follows from the state of the exercise for the pupil's own numbers: components of a rosette are answers.
femoop::mohr::PlaneState state_of(const Exercise& exercise, const Numbers& numbers);

/// Equal within half a percent of what such numbers reach, an angle within 0.2 degrees (a half turn more is the same
/// direction), a factor within a percent.
bool is_near(Asked asked, const Exercise& exercise, double a, double b);

} // namespace mohr
