#include "apps/drawing/results/case_numbers.h"

#include "apps/drawing/sketch/scene.h"

#include <cmath>
#include <utility>

namespace drawing {

using ui::Measure;

namespace {

constexpr double rounding = 1e-9; // of the largest value of its kind

} // namespace

CaseNumbers::CaseNumbers(const femoop::CaseResult& result, const ui::DisplayUnits& units) : units_(units)
{
    const femoop::Magnitudes most = result.magnitudes();
    least_ = {{Measure::Force, rounding * most.force},
              {Measure::Moment, rounding * most.moment},
              {Measure::Displacement, rounding * most.displacement},
              {Measure::Rotation, rounding * most.rotation}};
}

double CaseNumbers::without_rounding(double value, Measure measure) const
{
    const auto least = least_.find(measure);
    return least != least_.end() && std::abs(value) <= least->second ? 0.0 : value;
}

std::string CaseNumbers::number(double value, Measure measure) const
{
    return with_minus(units_.number(without_rounding(value, measure), measure));
}

std::string CaseNumbers::text(double value, Measure measure) const
{
    return with_minus(units_.text(without_rounding(value, measure), measure));
}

NumbersOfCases::NumbersOfCases(femoop::Results results, ui::DisplayUnits units)
    : results_(std::move(results)), units_(std::move(units))
{}

const CaseNumbers& NumbersOfCases::operator[](femoop::CaseId load_case)
{
    const auto found = numbers_.find(load_case);
    if (found != numbers_.end()) return found->second;
    return numbers_.emplace(load_case, CaseNumbers(results_[load_case], units_)).first->second;
}

} // namespace drawing
