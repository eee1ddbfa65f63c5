#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "apps/mohr/document/document.h"
#include "femoop/methods/mohr/criterion.h"
#include "femoop/methods/mohr/rosette.h"
#include "femoop/methods/mohr/space_state.h"

namespace mohr {

/// What exercises are about.
enum class ExerciseTopic : std::uint8_t { PlaneStress, PlaneStrain, Strain, Rosette, Inertia, Space, Criteria };
inline constexpr std::size_t n_exercise_topics = 7;

enum class Difficulty : std::uint8_t {
    Easy,   ///< whole numbers; the circle and its principal values
    Medium, ///< also directions, planes, derived values
    Hard    ///< also what needs the third direction, a material, or a state in space as it comes
};

/// What is asked, in the order in which one follows from another.
enum class Asked : std::uint8_t {
    StrainX, ///< of a rosette, as are both next
    StrainY,
    ShearStrain, ///< gamma
    Centre,
    Radius,
    First, ///< in the plane
    Second,
    Direction,          ///< of the first, from x [degrees]
    Normal,             ///< on the plane at `angle`
    Shear,              ///< likewise, as it is given: tau, gamma, Ixy
    LargestShearStrain, ///< of the plane
    Third,              ///< square to the plane: sz of a plane strain, ez of a free surface
    StressFirst,        ///< from the principal strains
    StressSecond,
    I1, ///< of a state in space
    I2,
    I3,
    SpaceFirst,
    SpaceSecond,
    SpaceThird,
    LargestShear, ///< in space
    Mean,
    VonMises,
    SpaceNormal, ///< on the plane of `normal`
    SpaceShear,
    FactorTresca,
    FactorVonMises,
    FactorRankine,
    FactorCoulomb
};
inline constexpr std::size_t n_asked = 29;

/// A state and what is to be found of it.
struct Exercise {
    ExerciseTopic topic = ExerciseTopic::PlaneStress;
    Difficulty difficulty = Difficulty::Easy;
    std::uint32_t seed = 1;
    femoop::mohr::PlaneState state{}; ///< as a tensor [MPa, 1e-6 or cm^4]; of a rosette what it measures
    femoop::mohr::SpaceState space{}; ///< of ExerciseTopic::Space [MPa]
    std::array<double, 3> gauges{};   ///< of ExerciseTopic::Rosette [degrees]
    std::array<double, 3> readings{}; ///< likewise [1e-6]
    double E = 0.0, nu = 0.0;         ///< [GPa]
    femoop::mohr::Strength strength{};
    double angle = 0.0;             ///< of the plane of Asked::Normal and Asked::Shear [degrees]
    std::array<double, 3> normal{}; ///< of the plane of Asked::SpaceNormal, whole numbers of a whole length
    std::vector<Asked> asked{};
};

/// The same for the same topic, difficulty and seed, on every machine.
Exercise exercise(ExerciseTopic topic, Difficulty difficulty, std::uint32_t seed);

/// The document that shows what is given, with the element not turned.
Document document_of(const Exercise& exercise);

bool is_strain(ExerciseTopic topic);
bool is_inertia(ExerciseTopic topic);

} // namespace mohr
