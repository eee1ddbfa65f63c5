#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "femoop/methods/mohr/criterion.h"

namespace femoop::mohr {

inline constexpr std::array all_criteria{Criterion::Tresca,      Criterion::VonMises,      Criterion::Rankine,
                                         Criterion::MohrCoulomb, Criterion::DruckerPrager, Criterion::HoekBrown};

/// How files and the command line call it: "mohr_coulomb".
std::string_view word(Criterion criterion);
std::optional<Criterion> criterion_named(std::string_view word);

/// A strength by its name in files: "fy", "phi" (in degrees there).
struct StrengthName {
    std::string_view word;
    double Strength::*value;
    bool is_stress;
};
/// Those that a criterion reads.
std::span<const StrengthName> strengths_of(Criterion criterion);

} // namespace femoop::mohr
