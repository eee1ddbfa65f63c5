#include "apps/cross/view/numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "apps/drawing/sketch/scene.h"
#include "apps/frame/document/fault/sentence.h"
#include "femoop/methods/cross/fraction.h"
#include "ui/text/language_manner.h"

namespace cross {

namespace fc = femoop::cross;

namespace {

ui::NumberFormat format_in(const ui::Catalogue& tr) { return {.digits = 4, .mark = ui::decimal_mark(tr.language())}; }

double largest_fixed_end(const fc::Problem& problem)
{
    double largest = 0.0;
    for (const double moment : problem.loading.fixed_end) largest = std::max(largest, std::abs(moment));
    for (const fc::Sway& sway : problem.sways)
        for (const double moment : sway.loading.fixed_end) largest = std::max(largest, std::abs(moment));
    return largest;
}

std::string with_decimals(double value, int decimals, ui::DecimalMark mark)
{
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
    std::string written(text.data());
    if (mark == ui::DecimalMark::Comma) std::ranges::replace(written, '.', ',');
    const bool is_zero = written.find_first_not_of("-0.,") == std::string::npos;
    return is_zero && written.front() == '-' ? written.substr(1) : drawing::with_minus(written);
}

} // namespace

ui::DisplayUnits units_of(const femoop::Model& model, const ui::Catalogue& tr)
{
    drawing::DrawOptions options;
    options.numbers = format_in(tr);
    return drawing::display_units(model, options);
}

std::string fault_text(const femoop::Fault& fault, const ui::Catalogue& tr) { return frame::sentence(fault, tr); }

Numbers::Numbers(const Document& document, const Solution& solution, const Look& look)
    : units_(units_of(document.model, look.tr)),
      signs_(look.signs),
      fractions_(look.fractions),
      digits_(document.method.digits)
{
    const double largest = units_.shown(largest_fixed_end(solution.task->problem), ui::Measure::Moment);
    if (largest > 0.0) decimals_ = std::clamp(4 - static_cast<int>(std::floor(std::log10(largest))), 0, 6);
}

Numbers Numbers::unrounded() const
{
    Numbers same = *this;
    same.digits_ = 0;
    return same;
}

std::string Numbers::moment(const fc::End& end, double end_moment) const
{
    return moment(signs_ == Signs::TensionSide && end.member ? fc::section_moment(end, end_moment) : end_moment);
}

std::string Numbers::moment(double value) const { return written(units_.shown(value, ui::Measure::Moment)); }

std::string Numbers::written(double shown) const
{
    if (fractions_)
        if (const auto fraction = fc::fraction_of(shown)) return drawing::with_minus(fc::fraction_text(*fraction));
    if (digits_ > 0) return drawing::with_minus(ui::number_text(shown, {digits_, units_.format().mark}));
    if (std::abs(shown) >= 1e7) return drawing::with_minus(ui::number_text(shown, units_.format()));
    return with_decimals(shown, decimals_, units_.format().mark);
}

std::string Numbers::factor(double value) const
{
    if (fractions_)
        if (const auto fraction = fc::fraction_of(value)) return fc::fraction_text(*fraction);
    return digits_ > 0 ? ui::number_text(value, {digits_, units_.format().mark})
                       : with_decimals(value, 3, units_.format().mark);
}

} // namespace cross
