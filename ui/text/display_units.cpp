#include "ui/text/display_units.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "ui/text/catalogue.h"

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

constexpr double lbf = 4.4482216152605, kgf = 9.80665; // N
constexpr NamedUnit newton{"N", 1.0}, kilonewton{"kN", 1.0e3}, kip{"kip", 1.0e3 * lbf};
constexpr NamedUnit metre{"m", 1.0}, centimetre{"cm", 1.0e-2}, millimetre{"mm", 1.0e-3}, foot{"ft", 0.3048},
    inch{"in", 0.0254};
constexpr NamedUnit megapascal{"MPa", 1.0e6}, ksi{"ksi", 1.0e3 * lbf / (0.0254 * 0.0254)}, derived{"", 0.0};

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

namespace {

/// A unit that can be chosen, in N and m.
constexpr std::array<NamedUnit, 52> sizes{{
    {"mm", 1.0e-3},
    {"cm", 1.0e-2},
    {"m", 1.0},
    {"in", 0.0254},
    {"ft", 0.3048},
    {"rad", 1.0},
    {"mrad", 1.0e-3},
    {"°", std::numbers::pi / 180.0},
    {"N", 1.0},
    {"kN", 1.0e3},
    {"MN", 1.0e6},
    {"kgf", kgf},
    {"tf", 1.0e3 * kgf},
    {"lbf", lbf},
    {"kip", 1.0e3 * lbf},
    {"N·mm", 1.0e-3},
    {"N·m", 1.0},
    {"kN·cm", 10.0},
    {"kN·m", 1.0e3},
    {"MN·m", 1.0e6},
    {"kgf·m", kgf},
    {"tf·m", 1.0e3 * kgf},
    {"lbf·ft", 0.3048 * lbf},
    {"kip·in", 25.4 * lbf},
    {"kip·ft", 304.8 * lbf},
    {"N/mm", 1.0e3},
    {"N/m", 1.0},
    {"kN/cm", 1.0e5},
    {"kN/m", 1.0e3},
    {"kgf/m", kgf},
    {"tf/m", 1.0e3 * kgf},
    {"lbf/ft", lbf / 0.3048},
    {"kip/ft", 1.0e3 * lbf / 0.3048},
    {"kip/in", 1.0e3 * lbf / 0.0254},
    {"Pa", 1.0},
    {"kPa", 1.0e3},
    {"MPa", 1.0e6},
    {"GPa", 1.0e9},
    {"kN/cm²", 1.0e7},
    {"kN/m²", 1.0e3},
    {"kgf/cm²", 1.0e4 * kgf},
    {"tf/m²", 1.0e3 * kgf},
    {"psi", lbf / (0.0254 * 0.0254)},
    {"ksi", 1.0e3 * lbf / (0.0254 * 0.0254)},
    {"mm²", 1.0e-6},
    {"cm²", 1.0e-4},
    {"m²", 1.0},
    {"in²", 0.0254 * 0.0254},
    {"mm⁴", 1.0e-12},
    {"cm⁴", 1.0e-8},
    {"m⁴", 1.0},
    {"in⁴", 0.0254 * 0.0254 * 0.0254 * 0.0254},
}};

constexpr std::string_view lengths[] = {"mm", "cm", "m", "in", "ft"};
constexpr std::string_view rotations[] = {"rad", "mrad", "°"};
constexpr std::string_view forces[] = {"N", "kN", "MN", "kgf", "tf", "lbf", "kip"};
constexpr std::string_view moments[] = {"N·mm",  "N·m",  "kN·cm",  "kN·m",   "MN·m",
                                        "kgf·m", "tf·m", "lbf·ft", "kip·in", "kip·ft"};
constexpr std::string_view line_loads[] = {"N/mm", "N/m",    "kN/cm",  "kN/m",  "kgf/m",
                                           "tf/m", "lbf/ft", "kip/ft", "kip/in"};
constexpr std::string_view stresses[] = {"Pa",    "kPa",     "MPa",   "GPa", "kN/cm²",
                                         "kN/m²", "kgf/cm²", "tf/m²", "psi", "ksi"};
constexpr std::string_view areas[] = {"mm²", "cm²", "m²", "in²"};
constexpr std::string_view second_moments[] = {"mm⁴", "cm⁴", "m⁴", "in⁴"};

constexpr std::array quantities{
    QuantityUnits{Measure::Length, "length", translatable("Length"), lengths},
    QuantityUnits{Measure::Displacement, "displacement", translatable("Displacement"), lengths},
    QuantityUnits{Measure::Rotation, "rotation", translatable("Rotation"), rotations},
    QuantityUnits{Measure::Force, "force", translatable("Force"), forces},
    QuantityUnits{Measure::Moment, "moment", translatable("Moment"), moments},
    QuantityUnits{Measure::ForcePerLength, "line_load", translatable("Force per length"), line_loads},
    QuantityUnits{Measure::Stress, "stress", translatable("Stress and modulus"), stresses},
    QuantityUnits{Measure::SectionLength, "section", translatable("Dimensions of a section"), lengths},
    QuantityUnits{Measure::Area, "area", translatable("Area"), areas},
    QuantityUnits{Measure::SecondMoment, "inertia", translatable("Second moment of area"), second_moments},
};

double size_of(std::string_view name) { return std::ranges::find(sizes, name, &NamedUnit::name)->si; }

/// As print has it: "kN·m", "cm⁴".
std::string printed(std::string_view unit)
{
    constexpr std::array<std::pair<std::string_view, std::string_view>, 4> signs{
        {{"*", "·"}, {"^2", "²"}, {"^4", "⁴"}, {"deg", "°"}}};
    std::string text(unit);
    for (const auto& [in_file, in_print] : signs)
        if (const std::size_t at = text.find(in_file); at != std::string::npos)
            text.replace(at, in_file.size(), in_print);
    return text;
}

} // namespace

std::span<const QuantityUnits> chosen_quantities() { return quantities; }

bool UnitChoices::choose(std::string_view quantity, std::string_view unit)
{
    const auto found = std::ranges::find(quantities, quantity, &QuantityUnits::code);
    if (found == quantities.end()) return false;
    const auto name = std::ranges::find(found->names, printed(unit));
    if (name == found->names.end() && !unit.empty()) return false;
    names_[static_cast<std::size_t>(found->measure)] = unit.empty() ? std::string_view() : *name;
    return true;
}

std::string UnitChoices::text() const
{
    std::string text;
    for (const QuantityUnits& quantity : quantities)
        if (const std::string_view unit = of(quantity.measure); !unit.empty())
            text += (text.empty() ? "" : " ") + std::string(quantity.code) + '=' + std::string(unit);
    return text;
}

DisplayUnits::DisplayUnits(UnitSystem system, BaseUnits base, NumberFormat format, UnitChoices choices)
    : system_(system), base_(std::move(base)), format_(format), choices_(choices)
{}

namespace {

// What the file counts in, in N and m.
double stored_size(Measure measure, const BaseUnits& base)
{
    const double F = base.newtons, L = base.metres;
    switch (measure) {
    case Measure::Rotation: return 1.0;
    case Measure::Force: return F;
    case Measure::Moment: return F * L;
    case Measure::ForcePerLength: return F / L;
    case Measure::Stress: return F / (L * L);
    case Measure::Area: return L * L;
    case Measure::SecondMoment: return std::pow(L, 4);
    default: return L;
    }
}

} // namespace

DisplayUnits DisplayUnits::per(Measure load) const
{
    DisplayUnits of_unit_load = *this;
    of_unit_load.per_ = load;
    return of_unit_load;
}

DisplayUnit DisplayUnits::unit(Measure measure) const
{
    constexpr std::array divided_ones{Measure::Force, Measure::Moment, Measure::Displacement, Measure::Rotation};
    const bool is_divided = per_ && std::ranges::find(divided_ones, measure) != divided_ones.end();
    return is_divided ? divided(measure, *per_) : undivided(measure);
}

DisplayUnit DisplayUnits::divided(Measure measure, Measure load) const
{
    const DisplayUnit over = undivided(measure), under = undivided(load), length = undivided(Measure::Length);
    DisplayUnit unit{over.name + "/" + under.name, over.factor / under.factor};
    const auto is_factor = [&](double factor) { return std::abs(unit.factor / factor - 1.0) < 1e-9; };
    if (measure == load) unit.name.clear();
    else if (measure == Measure::Moment && is_factor(length.factor)) unit.name = length.name;
    else if (measure == Measure::Force && is_factor(1.0 / length.factor)) unit.name = "1/" + length.name;
    return unit;
}

DisplayUnit DisplayUnits::undivided(Measure measure) const
{
    if (measure == Measure::MomentPerAngle && !choices_.of(Measure::Moment).empty()) {
        const DisplayUnit moment = undivided(Measure::Moment);
        return {moment.name + "/rad", moment.factor};
    }
    if (measure == Measure::ForcePerVolume) {
        const DisplayUnit force = undivided(Measure::Force), length = undivided(Measure::Length);
        return {force.name + "/" + powered(length.name, 3), force.factor / std::pow(length.factor, 3)};
    }
    const std::string_view chosen = choices_.of(measure);
    if (chosen.empty()) return unit_of_system(measure);
    return named(std::string(chosen), size_of(chosen), stored_size(measure, base_));
}

std::string DisplayUnits::summary() const
{
    std::string text = unit(Measure::Force).name + ", " + unit(Measure::Length).name;
    const double force = unit(Measure::Force).factor, length = unit(Measure::Length).factor;
    const auto add = [&](Measure measure, double following) {
        const DisplayUnit own = unit(measure);
        if (std::abs(own.factor / following - 1.0) > 1e-9) text += ", " + own.name;
    };
    add(Measure::Moment, force * length);
    add(Measure::ForcePerLength, force / length);
    return text;
}

DisplayUnit DisplayUnits::unit_of_system(Measure measure) const
{
    const Choice c = choice(system_, base_);
    const auto [force, length] = std::pair(c.force, c.length);
    const double F = base_.newtons;
    const double L = base_.metres;
    const std::string f(force.name);
    const std::string l(length.name);
    switch (measure) {
    case Measure::Plain:
    case Measure::ForcePerVolume: break; // which `undivided` knows
    case Measure::Length: return named(l, length.si, L);
    case Measure::Displacement: return named(std::string(c.displacement.name), c.displacement.si, L);
    case Measure::Rotation: return {"rad", 1.0};
    case Measure::Angle: return {"°", 1.0};
    case Measure::AngularVelocity: return {"rad/s", 1.0};
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
    return number(stored, measure) + (unit_name.empty() || unit_name == "°" ? "" : " ") + unit_name;
}

std::string DisplayUnits::place(double x, double y) const
{
    const char* const comma = format_.mark == DecimalMark::Comma ? "; " : ", ";
    return "(" + with_minus_signs(number(x, Measure::Length) + comma + number(y, Measure::Length)) + ")";
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
