#include "apps/drawing/quantity_typed.h"

#include <algorithm>
#include <optional>

#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/quantity_parser.h"
#include "femoop/model/quantity/unit_signs.h"
#include "ui/text/arithmetic.h"

namespace drawing {

using namespace femoop;
using ui::Measure;

namespace {

/// A number with a unit as files have it: calculated, with a decimal point, the unit as it is shown or as files have
/// it.
std::string as_in_file(std::string_view text)
{
    const std::optional<ui::LeadingNumber> number = ui::leading_number(text);
    if (!number) return std::string(text);
    const std::string rest = femoop::with_file_signs(text.substr(number->length));
    if (number->is_computed) return femoop::number_text(number->value) + rest;
    std::string plain(text.substr(0, number->length));
    std::ranges::replace(plain, ',', '.');
    return plain + rest;
}

std::variant<Quantity, Fault> typed_quantity(std::string_view text, Dimension dimension, const Units& file,
                                             const ui::DisplayUnit& unit, AngleUnit angle)
{
    const std::optional<double> bare = ui::number_typed(text);
    if (bare && unit.factor == 1.0) return Quantity(*bare);
    const std::string full = bare ? femoop::number_text(*bare) + ' ' + femoop::with_file_signs(unit.name)
                                  : as_in_file(text);
    auto parsed = parse_quantity(full, dimension, file, angle);
    if (auto* const fault = std::get_if<Fault>(&parsed)) return std::move(*fault);
    const double value = std::get<double>(parsed);
    return dimension == Dimension{} ? Quantity(value) : Quantity(value, full);
}

} // namespace

Dimension dimension_measured(Measure measure)
{
    switch (measure) {
    case Measure::Plain: break;
    case Measure::Length:
    case Measure::Displacement:
    case Measure::SectionLength: return dimension::length;
    case Measure::Rotation:
    case Measure::Angle: return dimension::angle;
    case Measure::Force: return dimension::force;
    case Measure::Moment: return dimension::moment;
    case Measure::ForcePerLength: return dimension::force_per_length;
    case Measure::MomentPerLength: return dimension::moment_per_length;
    case Measure::MomentPerAngle: return dimension::moment_per_angle;
    case Measure::Stress:
    case Measure::FoundationModulus: return dimension::stress;
    case Measure::Area: return dimension::area;
    case Measure::SecondMoment: return dimension::second_moment;
    case Measure::Density: return dimension::density;
    case Measure::Temperature: return dimension::temperature;
    case Measure::Expansion: return dimension::expansion;
    }
    return dimension::none;
}

std::variant<Quantity, Fault> quantity_typed(std::string_view text, Measure measure, const Units& file,
                                             const ui::DisplayUnits& shown)
{
    return typed_quantity(text, dimension_measured(measure), file, shown.unit(measure),
                          measure == Measure::Angle ? AngleUnit::Degrees : AngleUnit::Radians);
}

std::variant<Quantity, Fault> quantity_typed(std::string_view text, Dimension dimension, const Units& file,
                                             const ui::DisplayUnit& shown)
{
    return typed_quantity(text, dimension, file, shown, AngleUnit::Radians);
}

ui::BaseUnits base_units(const Units& units)
{
    return {std::string(name(units.length)), metres(units.length), std::string(name(units.force)),
            newtons(units.force)};
}

} // namespace drawing
