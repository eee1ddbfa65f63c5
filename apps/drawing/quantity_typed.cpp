#include "apps/drawing/quantity_typed.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "femoop/edit/short_number.h"
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

struct Term {
    double sign;
    std::string_view text;
};

/// The terms of a sum: signs within parentheses, of exponents and of factors part none.
std::vector<Term> terms_of(std::string_view text)
{
    std::vector<Term> terms;
    std::size_t begin = 0;
    double sign = 1.0;
    int depth = 0;
    char last = '\0', before_last = '\0'; // that are no spaces
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == ' ') continue;
        if (c == '(') ++depth;
        if (c == ')') --depth;
        const bool is_exponent = (last == 'e' || last == 'E') && before_last >= '0' && before_last <= '9';
        const bool follows_term = last != '\0' && std::string_view("+-*/^(").find(last) == std::string_view::npos;
        if ((c == '+' || c == '-') && depth == 0 && follows_term && !is_exponent) {
            terms.push_back({sign, text.substr(begin, i - begin)});
            sign = c == '+' ? 1.0 : -1.0;
            begin = i + 1;
        }
        before_last = last;
        last = c;
    }
    terms.push_back({sign, text.substr(begin)});
    return terms;
}

std::variant<Quantity, Fault> typed_term(std::string_view text, Dimension dimension, const Units& file,
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

/// One term, or a sum of terms each with a unit of its own: `1.3 m + 10 cm`.
std::variant<Quantity, Fault> typed_quantity(std::string_view text, Dimension dimension, const Units& file,
                                             const ui::DisplayUnit& unit, AngleUnit angle)
{
    auto whole = typed_term(text, dimension, file, unit, angle);
    if (std::holds_alternative<Quantity>(whole)) return whole;
    const std::vector<Term> terms = terms_of(text);
    if (terms.size() < 2) return whole;
    double sum = 0.0, largest = 0.0;
    for (const Term& term : terms) {
        const auto one = typed_term(term.text, dimension, file, unit, angle);
        if (!std::holds_alternative<Quantity>(one)) return whole;
        sum += term.sign * std::get<Quantity>(one);
        largest = std::max(largest, std::abs(std::get<Quantity>(one).value()));
    }
    return Quantity(short_number(sum, largest));
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
    case Measure::AngularVelocity: return {.time = -1, .angle = 1};
    case Measure::ForcePerVolume: return {.length = -3, .force = 1};
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
