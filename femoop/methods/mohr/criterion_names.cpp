#include "femoop/methods/mohr/criterion_names.h"

#include <algorithm>

namespace femoop::mohr {

namespace {

constexpr std::array<std::string_view, all_criteria.size()> words{"tresca",       "von_mises",      "rankine",
                                                                  "mohr_coulomb", "drucker_prager", "hoek_brown"};

constexpr std::array yield{StrengthName{"fy", &Strength::fy, true}};
constexpr std::array brittle{StrengthName{"ft", &Strength::ft, true}, StrengthName{"fc", &Strength::fc, true}};
constexpr std::array friction{StrengthName{"c", &Strength::c, true}, StrengthName{"phi", &Strength::phi, false}};
constexpr std::array rock{StrengthName{"sci", &Strength::sci, true}, StrengthName{"m", &Strength::m, false},
                          StrengthName{"s", &Strength::s, false}};

} // namespace

std::string_view word(Criterion criterion) { return words[static_cast<std::size_t>(criterion)]; }

std::optional<Criterion> criterion_named(std::string_view name)
{
    const auto at = std::ranges::find(words, name);
    if (at == words.end()) return std::nullopt;
    return all_criteria[static_cast<std::size_t>(at - words.begin())];
}

std::span<const StrengthName> strengths_of(Criterion criterion)
{
    switch (criterion) {
    case Criterion::Tresca:
    case Criterion::VonMises: return yield;
    case Criterion::Rankine: return brittle;
    case Criterion::MohrCoulomb:
    case Criterion::DruckerPrager: return friction;
    case Criterion::HoekBrown: break;
    }
    return rock;
}

} // namespace femoop::mohr
