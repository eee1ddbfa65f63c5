#include "femoop/plane/model/field.h"

#include <algorithm>
#include <cmath>

namespace femoop::plane {

namespace {

double value_of(const Quantity& constant, const FieldPlace& /*at*/) { return constant; }

double value_of(const Field::Ends& ends, const FieldPlace& at)
{
    const double share = at.length > 0.0 ? at.s / at.length : 0.0;
    return ends.start + share * (ends.end - ends.start);
}

double value_of(const Field::Polynomial& terms, const FieldPlace& at)
{
    double sum = 0.0;
    for (const Field::Term& term : terms) sum += term.factor * std::pow(at.x, term.i) * std::pow(at.y, term.j);
    return sum;
}

double value_of(const Field::Table& table, const FieldPlace& at)
{
    const double place = place_along(table, at);
    const auto& rows = table.rows;
    const auto above = std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.first > place; });
    if (above == rows.begin()) return rows.front().second;
    if (above == rows.end()) return rows.back().second;
    const auto& [a, first] = *(above - 1);
    const auto& [b, second] = *above;
    return first + (place - a) / (b - a) * (second - first);
}

} // namespace

double place_along(const Field::Table& table, const FieldPlace& at)
{
    switch (table.along) {
    case Field::Along::x: return at.x;
    case Field::Along::y: return at.y;
    case Field::Along::s: return at.s;
    case Field::Along::r: break;
    }
    return table.about.empty() ? std::hypot(at.x, at.y) : std::hypot(at.x - table.about[0], at.y - table.about[1]);
}

double value(const Field& field, const FieldPlace& at)
{
    return std::visit([&](const auto& form) { return value_of(form, at); }, field.form);
}

bool needs_curve(const Field& field)
{
    if (std::holds_alternative<Field::Ends>(field.form)) return true;
    const auto* const table = std::get_if<Field::Table>(&field.form);
    return table != nullptr && table->along == Field::Along::s;
}

} // namespace femoop::plane
