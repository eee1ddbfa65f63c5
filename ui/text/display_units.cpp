#include "ui/text/display_units.h"

#include <cmath>
#include <utility>

namespace ui {

namespace {

struct NamedUnit {
    std::string_view name;
    double si;
};

// The units that make up a system: in it everything is a product of powers of a length and a force.
struct Choice {
    NamedUnit force;
    NamedUnit length; // of the structure
    NamedUnit displacement;
    NamedUnit section; // of cross-sections
    NamedUnit stress;  // a name of its own, or empty: force / length^2
};

constexpr NamedUnit newton{"N", 1.0}, kilonewton{"kN", 1.0e3}, kip{"kip", 4448.2216152605};
constexpr NamedUnit metre{"m", 1.0}, centimetre{"cm", 1.0e-2}, millimetre{"mm", 1.0e-3}, foot{"ft", 0.3048},
    inch{"in", 0.0254};
constexpr NamedUnit megapascal{"MPa", 1.0e6}, ksi{"ksi", 4448.2216152605 / (0.0254 * 0.0254)}, derived{"", 0.0};

Choice choice(UnitSystem system, const BaseUnits& base)
{
    const NamedUnit file_length{base.length, base.metres};
    switch (system) {
    case UnitSystem::File: break;
    case UnitSystem::Si: return {newton, metre, millimetre, millimetre, megapascal};
    case UnitSystem::KnM: return {kilonewton, metre, millimetre, centimetre, megapascal};
    case UnitSystem::KnCm: return {kilonewton, centimetre, centimetre, centimetre, derived};
    case UnitSystem::Us: return {kip, foot, inch, inch, ksi};
    }
    return {{base.force, base.newtons}, file_length, file_length, file_length, derived};
}

std::string powered(std::string_view name, int power)
{
    static constexpr std::string_view raised[] = {"", "", "²", "³", "⁴"};
    return std::string(name) + std::string(raised[power]);
}

DisplayUnit named(std::string name, double si, double stored_si) { return {std::move(name), stored_si / si}; }

} // namespace

DisplayUnits::DisplayUnits(UnitSystem system, BaseUnits base, NumberFormat format)
    : system_(system), base_(std::move(base)), format_(format)
{}

DisplayUnit DisplayUnits::unit(Measure measure) const
{
    const Choice c = choice(system_, base_);
    const auto [force, length] = std::pair(c.force, c.length);
    const double F = base_.newtons;
    const double L = base_.metres;
    const std::string f(force.name);
    const std::string l(length.name);
    switch (measure) {
    case Measure::Plain: break;
    case Measure::Length: return named(l, length.si, L);
    case Measure::Displacement: return named(std::string(c.displacement.name), c.displacement.si, L);
    case Measure::Rotation: return {"rad", 1.0};
    case Measure::Angle: return {"°", 1.0};
    case Measure::Force: return named(f, force.si, F);
    case Measure::Moment: return named(f + "·" + l, force.si * length.si, F * L);
    case Measure::ForcePerLength: return named(f + "/" + l, force.si / length.si, F / L);
    case Measure::MomentPerLength: return named(f + "·" + l + "/" + l, force.si, F);
    case Measure::MomentPerAngle: return named(f + "·" + l + "/rad", force.si * length.si, F * L);
    case Measure::Stress:
        if (!c.stress.name.empty()) return named(std::string(c.stress.name), c.stress.si, F / (L * L));
        [[fallthrough]];
    case Measure::FoundationModulus:
        return named(f + "/" + powered(l, 2), force.si / (length.si * length.si), F / (L * L));
    case Measure::Area: return named(powered(c.section.name, 2), std::pow(c.section.si, 2), L * L);
    case Measure::SecondMoment: return named(powered(c.section.name, 4), std::pow(c.section.si, 4), std::pow(L, 4));
    case Measure::SectionLength: return named(std::string(c.section.name), c.section.si, L);
    case Measure::Density: return named("kg/m³", 1.0, F / std::pow(L, 4));
    case Measure::Temperature: return {"°C", 1.0};
    case Measure::Expansion: return {"1/K", 1.0};
    }
    return {"", 1.0};
}

std::string DisplayUnits::number(double stored, Measure measure) const
{
    return number_text(shown(stored, measure), format_);
}

std::string DisplayUnits::text(double stored, Measure measure) const
{
    const std::string unit_name = unit(measure).name;
    return number(stored, measure) + (unit_name.empty() || measure == Measure::Angle ? "" : " ") + unit_name;
}

std::string DisplayUnits::label(std::string_view name, Measure measure) const
{
    const std::string unit_name = unit(measure).name;
    return unit_name.empty() ? std::string(name) : std::string(name) + " [" + unit_name + "]";
}

std::string_view code(UnitSystem system)
{
    switch (system) {
    case UnitSystem::File: break;
    case UnitSystem::Si: return "si";
    case UnitSystem::KnM: return "kn-m";
    case UnitSystem::KnCm: return "kn-cm";
    case UnitSystem::Us: return "us";
    }
    return "file";
}

std::optional<UnitSystem> unit_system_named(std::string_view name)
{
    for (const UnitSystem system : all_unit_systems) {
        if (name == code(system)) return system;
    }
    return std::nullopt;
}

UnitSystem preferred_system(const BaseUnits& base)
{
    const bool is_us = base.force == "lbf" || base.force == "kip" || base.length == "in" || base.length == "ft";
    return is_us ? UnitSystem::Us : UnitSystem::KnM;
}

} // namespace ui
