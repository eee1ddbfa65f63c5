#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "femoop/methods/mohr/criterion.h"
#include "femoop/model/quantity/dimension.h"

namespace mohr {

/// What the circle is drawn of.
enum class Subject : std::uint8_t { PlaneStress, PlaneStrain, Strain, Rosette, Inertia, SpaceStress, Section };
inline constexpr std::size_t n_subjects = 7;

/// Names one of a document's typed numbers: its place among those of its group.
enum class Group : std::uint8_t { State, Elasticity, Strength, Section };
struct NumberId {
    Group group = Group::State;
    std::size_t place = 0;

    friend bool operator==(const NumberId&, const NumberId&) = default;
};

/// The strengths by their places in Document::strengths.
enum class StrengthPlace : std::uint8_t { fy, ft, fc, c, phi, sci, m, s };
inline constexpr std::size_t n_strengths = 8;

/// What is saved: a state, its numbers as they were typed, the plane that is looked at, and a criterion of failure.
///
/// Numbers   State: the subject's components in the order of `names` (a rosette: three directions in degrees, then
///           three readings; a section: N, V, M and the height of the fibre); Elasticity: E, nu; Strength: as
///           StrengthPlace, phi in degrees
/// Units     as typed; strains in 1e-6
struct Document {
    Subject subject = Subject::PlaneStress;
    std::array<std::vector<std::string>, n_subjects> numbers{}; ///< of every subject, so that going back loses nothing
    std::string section{}; ///< of Subject::Section: a profile, "IPE 300", or a shape, "rectangle b=90mm h=210mm"
    std::array<std::string, 2> elasticity{};
    std::array<std::string, n_strengths> strengths{};
    std::optional<femoop::mohr::Criterion> criterion{};
    std::array<std::vector<std::vector<std::string>>, n_subjects> paths{}; ///< states of a loading path, as typed
    double angle = 0.0;                          ///< of the plane's normal from x [degrees], in (-180, 180]
    std::array<double, 3> normal{1.0, 1.0, 1.0}; ///< of the plane in space, of any length but 0

    friend bool operator==(const Document&, const Document&) = default;

    const std::vector<std::string>& state() const { return numbers[static_cast<std::size_t>(subject)]; }
    const std::vector<std::vector<std::string>>& path() const { return paths[static_cast<std::size_t>(subject)]; }
    std::vector<std::vector<std::string>>& path() { return paths[static_cast<std::size_t>(subject)]; }
    std::vector<std::string>& state() { return numbers[static_cast<std::size_t>(subject)]; }
};

/// A textbook's numbers for every subject.
Document textbook_state();

bool is_in_space(Subject subject);
/// Its states can follow one another on a loading path: stresses and strains of a plane by their components.
bool has_path(Subject subject);
/// "σx", "σy", "τxy"; of a rosette "a", "b", "c" twice.
std::span<const std::string_view> names(Subject subject);
femoop::Dimension dimension_of(Subject subject, std::size_t place);
/// What bare numbers of it count: "10⁻⁶" of a strain, "°" of a gauge's direction, else "".
std::string_view bare_unit(Subject subject, std::size_t place);

/// The strengths that a criterion reads.
std::span<const StrengthPlace> strengths_of(femoop::mohr::Criterion criterion);
std::string_view name(StrengthPlace strength);           ///< "fy", "φ", "σci"
std::string_view name(Subject subject, NumberId number); ///< "τxy", "E", "φ"; "section" of what is a section's text

/// The text of one number; by reference where it is set.
const std::string& text_of(const Document& document, NumberId number);
std::string& text_of(Document& document, NumberId number);

/// About how much memory it takes [bytes]: a history is bounded by it.
std::size_t memory_footprint(const Document& document);

} // namespace mohr
