#include "apps/drawing/member/expression_lines.h"

#include <algorithm>
#include <cmath>

#include "apps/drawing/results/diagram.h"
#include "femoop/result/expression.h"

namespace drawing {

namespace {

void replace_all(std::string& text, std::string_view what, std::string_view with)
{
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
        text.replace(at, what.size(), with);
}

// "1.5e-05" as "1.5·10⁻⁵".
void raise_exponents(std::string& text)
{
    static constexpr std::string_view digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    for (std::size_t at = text.find('e'); at != std::string::npos; at = text.find('e', at + 1)) {
        std::string power = text[at + 1] == '-' ? "·10⁻" : "·10";
        std::size_t end = at + 2;
        for (bool is_leading = true; end < text.size() && text[end] >= '0' && text[end] <= '9'; ++end) {
            is_leading = is_leading && text[end] == '0';
            if (!is_leading) power += digits[text[end] - '0'];
        }
        text.replace(at, end - at, power);
    }
}

std::string for_readers(std::string formula, ui::DecimalMark mark)
{
    raise_exponents(formula);
    replace_all(formula, "-", "−");
    if (mark == ui::DecimalMark::Comma) replace_all(formula, ".", ",");
    return formula;
}

// In the units shown, without terms that nobody could see.
femoop::Expression shown(femoop::Expression expression, double value_factor, double length_factor, double least)
{
    double reach = 1.0, factor = value_factor;
    for (double& c : expression.coefficients) {
        if (std::abs(c) * reach <= least) c = 0.0;
        c *= factor;
        reach *= expression.to;
        factor /= length_factor;
    }
    return expression;
}

} // namespace

std::vector<ExpressionLine> expression_lines(const femoop::Curve& curve, femoop::MemberComponent component,
                                             const ui::DisplayUnits& units, double least)
{
    const double value_factor = units.unit(measure_of(component)).factor;
    const double length_factor = units.unit(ui::Measure::Length).factor;
    std::vector<ExpressionLine> lines;
    for (const femoop::Expression& expression : femoop::expressions(curve, component)) {
        const femoop::Expression seen = shown(expression, value_factor, length_factor, least);
        std::string formula = for_readers(femoop::text(seen, units.format().digits), units.format().mark);
        const bool goes_on = !lines.empty() && lines.back().formula == formula;
        if (goes_on) lines.back().to = expression.to;
        else lines.push_back({expression.from, expression.to, std::move(formula)});
    }
    return lines;
}

} // namespace drawing
