#include "apps/mohr/document/edit.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "apps/mohr/document/degree.h"
#include "apps/mohr/document/section_text.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/quantity_parser.h"
#include "femoop/model/quantity/unit_signs.h"
#include "ui/text/arithmetic.h"
#include "ui/text/catalogue.h"

namespace mohr {

namespace fm = femoop::mohr;
using ui::translatable;

namespace {

Edit judged(Document document)
{
    auto fault = why_not(document);
    return {std::move(document), std::move(fault)};
}

/// What stands behind the number of a text, as files write it.
std::string unit_behind(std::string_view text)
{
    const auto number = ui::leading_number(text);
    if (!number) return "";
    std::string_view rest = text.substr(number->length);
    while (rest.starts_with(' ')) rest.remove_prefix(1);
    while (rest.ends_with(' ')) rest.remove_suffix(1);
    return femoop::with_file_signs(rest);
}

std::string with_unit(double value, const std::string& unit)
{
    return femoop::number_text(value + 0.0) + (unit.empty() ? "" : " " + unit);
}

/// The unit that a bare number of this place means: its own, else that of another number of the state.
std::string usual_unit(const Document& document, NumberId number)
{
    if (const std::string own = unit_behind(text_of(document, number)); !own.empty() || number.group != Group::State)
        return own;
    if (dimension_of(document.subject, number.place) == femoop::dimension::none) return "";
    for (const std::string& text : document.state())
        if (const std::string unit = unit_behind(text); !unit.empty()) return unit;
    return "";
}

/// A fibre that another section does not reach goes to its edge.
void keep_fibre_inside(Document& document)
{
    if (document.subject != Subject::Section) return;
    const auto figure = section_figure(document.section);
    const auto* section = std::get_if<fm::SectionFigure>(&figure);
    const auto fibre = femoop::parse_quantity(document.state()[3], dimension_of(Subject::Section, 3), newtons_and_mm);
    const auto* y = std::get_if<double>(&fibre);
    if (section == nullptr || y == nullptr) return;
    if (*y > section->top()) document.state()[3] = with_unit(section->top(), "mm");
    if (*y < section->bottom()) document.state()[3] = with_unit(section->bottom(), "mm");
}

} // namespace

Edit with_number(const Document& document, NumberId number, std::string_view text)
{
    Document next = document;
    const auto leading = ui::leading_number(text);
    if (!leading || number.group == Group::Section) {
        text_of(next, number) = std::string(text);
        if (number.group == Group::Section) keep_fibre_inside(next);
        return judged(std::move(next));
    }
    const std::string unit = unit_behind(text);
    text_of(next, number) = with_unit(leading->value, unit.empty() ? usual_unit(document, number) : unit);
    return judged(std::move(next));
}

Edit with_angle(const Document& document, double degrees)
{
    Document next = document;
    const double turn = std::remainder(degrees, 360.0);
    next.angle = turn <= -180.0 ? 180.0 : turn + 0.0;
    return judged(std::move(next));
}

Edit with_normal(const Document& document, const std::array<double, 3>& normal)
{
    Document next = document;
    next.normal = normal;
    return judged(std::move(next));
}

Edit with_plane(const Document& document, const fm::PlaneState& state)
{
    if (document.subject == Subject::Section)
        return {document,
                Fault{ui::Message(translatable("the stresses follow from the section forces; change these"))}};
    Document next = document;
    auto& texts = next.state();
    const Solution before = solve(document);
    if (before.rosette) {
        const double largest = std::max({std::abs(state.x), std::abs(state.y), std::abs(state.xy)});
        for (std::size_t i = 0; i < 3; ++i)
            texts[3 + i] = with_unit(rounded(fm::rotated(state, before.rosette->angles[i]).x, largest, 6), "");
        return judged(std::move(next));
    }
    const std::array<double, 3> values{state.x, state.y, fm::given_shear(before.state.kind, state.xy)};
    const std::string unit = dimension_of(document.subject, 0) == femoop::dimension::none ? "" : before.unit;
    for (std::size_t i = 0; i < 3; ++i) texts[i] = with_unit(values[i], unit);
    return judged(std::move(next));
}

Edit with_principal(const Document& document, double first, double second, double degrees)
{
    const fm::PlaneState state = fm::from_principal(first, second, degrees * degree);
    const double largest = std::max(std::abs(first), std::abs(second));
    return with_plane(document,
                      {rounded(state.x, largest, 14), rounded(state.y, largest, 14), rounded(state.xy, largest, 14)});
}

Edit with_space(const Document& document, const fm::SpaceState& s)
{
    Document next = document;
    const std::array<double, 6> values{s.x, s.y, s.z, s.xy, s.yz, s.zx};
    const std::string unit = solve(document).unit;
    for (std::size_t i = 0; i < values.size(); ++i) next.state()[i] = with_unit(values[i], unit);
    return judged(std::move(next));
}

Edit with_space_principal(const Document& document, const fm::SpacePrincipal& principal)
{
    fm::SpaceState s = fm::from_principal(principal);
    double largest = 0.0;
    for (const double value : principal.values) largest = std::max(largest, std::abs(value));
    for (double* const value : {&s.x, &s.y, &s.z, &s.xy, &s.yz, &s.zx}) *value = rounded(*value, largest, 12);
    return with_space(document, s);
}

Edit with_path_state(const Document& document)
{
    Document next = document;
    next.path().push_back(document.state());
    return judged(std::move(next));
}

Edit without_path(const Document& document)
{
    Document next = document;
    next.path().clear();
    return judged(std::move(next));
}

Edit with_fibre(const Document& document, double y)
{
    Document next = document;
    next.state().back() = with_unit(y, "mm");
    return judged(std::move(next));
}

double rounded(double value, double largest, int digits)
{
    if (!(largest > 0.0) || !std::isfinite(largest)) return value;
    // A power of ten below 1 has no exact double, so what is rounded is the value times its inverse.
    const int exponent = digits - 1 - static_cast<int>(std::floor(std::log10(largest)));
    const double power = std::pow(10.0, std::abs(exponent));
    const double result = exponent >= 0 ? std::round(value * power) / power : std::round(value / power) * power;
    return std::isfinite(result) ? result + 0.0 : value;
}

double round_step(double least)
{
    double step = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {2.0, 2.5, 2.0})
        if (step < least) step *= factor;
    return step;
}

} // namespace mohr
