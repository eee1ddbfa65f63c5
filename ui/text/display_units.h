#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "ui/text/number_format.h"

namespace ui {

/// What a number on the screen measures. Displacements have a measure of their own because they are shown in a
/// smaller unit than lengths.
enum class Measure : std::uint8_t {
    Plain,
    Length,
    Displacement,
    Rotation, ///< rad
    Angle,    ///< degrees
    Force,
    Moment,
    ForcePerLength,
    MomentPerLength,
    MomentPerAngle,
    Stress,
    FoundationModulus,
    AngularVelocity, ///< rad/s
    ForcePerVolume,  ///< follows from force and length
    Area,
    SecondMoment,
    SectionLength, ///< dimensions of a cross-section
    Density,
    Temperature,
    Expansion
};
inline constexpr std::size_t n_measures = static_cast<std::size_t>(Measure::Expansion) + 1;

/// Units that results and properties are shown in, whatever the file counts in.
///
///   File   the file's own base units, for everything
///   Si     N, m, MPa            mm for displacements and sections
///   KnM    kN, m, MPa           mm for displacements, cm^2 and cm^4 for sections
///   KnCm   kN, cm, kN/cm^2
///   Us     kip, ft, ksi         in for displacements and sections
enum class UnitSystem : std::uint8_t { File, Si, KnM, KnCm, Us };

inline constexpr UnitSystem all_unit_systems[] = {UnitSystem::File, UnitSystem::Si, UnitSystem::KnM, UnitSystem::KnCm,
                                                  UnitSystem::Us};

std::string_view code(UnitSystem system); ///< "file", "si", "kn-m", "kn-cm", "us"
std::optional<UnitSystem> unit_system_named(std::string_view code);

/// A quantity whose unit can be chosen by itself, and the units that it can have.
struct QuantityUnits {
    Measure measure;
    std::string_view code;  ///< in settings and on the command line: "moment"
    std::string_view label; ///< to be translated: "Moment"
    std::span<const std::string_view> names;
};
std::span<const QuantityUnits> chosen_quantities();

/// Units that were chosen quantity by quantity, in place of those of the system.
class UnitChoices {
public:
    /// One of the names of the quantity's units, or empty: that of the system.
    std::string_view of(Measure measure) const { return names_[static_cast<std::size_t>(measure)]; }
    /// False for a quantity or a unit that is not among those that can be chosen. The unit is written as print or as a
    /// file has it: "kN·m", "kN*m"; empty: the system's again.
    bool choose(std::string_view quantity, std::string_view unit);
    /// "moment=kN·cm stress=kN/cm²": by `choose`, each gives them again.
    std::string text() const;

    friend bool operator==(const UnitChoices&, const UnitChoices&) = default;

private:
    std::array<std::string_view, n_measures> names_{}; ///< of `chosen_quantities`
};

/// The base units of the file's numbers, as names and in SI.
struct BaseUnits {
    std::string length = "m";
    double metres = 1.0;
    std::string force = "kN";
    double newtons = 1.0e3;

    friend bool operator==(const BaseUnits&, const BaseUnits&) = default;
};

/// A unit on the screen: shown = stored * factor.
struct DisplayUnit {
    std::string name; ///< "kN·m", "cm⁴"; empty for a plain number
    double factor = 1.0;
};

/// Turns the file's numbers into texts with units, and typed numbers back.
class DisplayUnits {
public:
    DisplayUnits() = default;
    DisplayUnits(UnitSystem system, BaseUnits base, NumberFormat format, UnitChoices choices = {});

    UnitSystem system() const { return system_; }
    const NumberFormat& format() const { return format_; }
    DisplayUnit unit(Measure measure) const;
    double shown(double stored, Measure measure) const { return stored * unit(measure).factor; }
    double stored(double shown, Measure measure) const { return shown / unit(measure).factor; }
    std::string number(double stored, Measure measure) const; ///< "12.5"
    std::string text(double stored, Measure measure) const;   ///< "12.5 kN·m"
    std::string place(double x, double y) const; ///< "(1.5, −2)" in the unit of lengths, "(1,5; −2)" with that mark
    /// A label with its unit in brackets: "Length [m]"; without one for a plain number.
    std::string label(std::string_view name, Measure measure) const;
    /// Those that numbers without a unit are counted in: "kN, m", and what a person chose that does not follow from
    /// these: "kN, m, kN·cm".
    std::string summary() const;
    DisplayUnit unit_of_system(Measure measure) const; ///< whatever was chosen
    /// For what a unit load does: forces, moments and displacements over the load's own unit, so that a moment under a
    /// force is a length. \pre a force or a moment
    DisplayUnits per(Measure load) const;

private:
    DisplayUnit undivided(Measure measure) const;
    DisplayUnit divided(Measure measure, Measure load) const;

    UnitSystem system_ = UnitSystem::KnM;
    BaseUnits base_;
    NumberFormat format_;
    UnitChoices choices_;
    std::optional<Measure> per_; ///< of a unit load
};

/// kip and ft for a file in lbf, kip, in or ft, else kN and m.
UnitSystem preferred_system(const BaseUnits& base);

} // namespace ui
