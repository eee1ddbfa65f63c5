#include "femoop/io/verify.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <variant>

#include "femoop/io/cross/cross_check.h"
#include "femoop/io/influence/influence_check.h"
#include "femoop/io/train/train_check.h"
#include "femoop/load/place_along.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/result/case_magnitudes.h"
#include "femoop/result/magnitudes.h"

namespace femoop {

namespace {

constexpr double default_rtol = 1.0e-6;

std::string_view word(ExpectedAnalysis analysis)
{
    static constexpr std::array<std::string_view, 5> words{"linear", translatable("p_delta"), translatable("buckling"),
                                                           translatable("modal"), translatable("plastic")};
    return words[static_cast<std::size_t>(analysis)];
}

std::string_view word(ExpectedQuantity quantity)
{
    static constexpr std::array<std::string_view, 7> words{translatable("displacement"),   translatable("reaction"),
                                                           translatable("section_force"),  translatable("extreme"),
                                                           translatable("load_factor"),    translatable("frequency"),
                                                           translatable("collapse_factor")};
    return words[static_cast<std::size_t>(quantity)];
}

bool is_linear(const Expected& check)
{
    return check.analysis == ExpectedAnalysis::Linear && check.quantity <= ExpectedQuantity::Extreme;
}

std::string text(const Position& position)
{
    if (const auto* percent = std::get_if<Percent>(&position)) return number_text(percent->value) + "%";
    const Quantity& length = std::get<Quantity>(position);
    return length.has_text() ? std::string(length.text()) : number_text(length);
}

std::string component_text(const Model& model, const Expected& check)
{
    if (check.component) return std::string(name(*check.component, model.analysis));
    if (!check.dof) return "";
    const bool is_force = check.quantity == ExpectedQuantity::Reaction;
    return std::string(is_force ? force_name(*check.dof) : name(*check.dof));
}

/// "case L: section_force M of member AB at 50% (- side)"
std::string describe_check(const Model& model, const Expected& check, const Translator& tr)
{
    std::string what;
    const auto add = [&](const std::string& words) { what += (what.empty() ? "" : " ") + words; };
    if (check.load_case) add(fill(tr("case {0}:"), {model.case_name(*check.load_case)}));
    if (check.analysis != ExpectedAnalysis::Linear) add(tr(word(check.analysis)));
    add(tr(word(check.quantity)));
    if (const std::string component = component_text(model, check); !component.empty()) add(component);
    if (check.extreme) add(*check.extreme == ExtremeKind::Max ? "max" : "min");
    if (check.mode) add(std::to_string(*check.mode));
    if (check.node) add(fill(tr("of node {0}"), {model[*check.node].id}));
    if (check.member) add(fill(tr("of member {0}"), {model[*check.member].id}));
    if (check.at) add(fill(tr("at {0}"), {text(*check.at)}));
    if (check.side) add(*check.side == Side::Before ? tr("(- side)") : tr("(+ side)"));
    return what;
}

/// A section force or a local displacement at a place along a member.
double along_member(const Expected& check, const Curve& curve)
{
    const double x = along(check.at.value(), curve.length());
    const bool is_end = x >= curve.length() * (1.0 - 1.0e-9);
    const Side side = is_end ? Side::Before : check.side.value_or(Side::After);
    return curve.value(check.component.value(), x, side);
}

double extreme(const Expected& check, const Curve& curve)
{
    const Extremes extremes = curve.extremes(check.component.value());
    return check.extreme.value() == ExtremeKind::Max ? extremes.max.value : extremes.min.value;
}

/// What the result comes from.
double magnitude_of(const Expected& check, const Magnitudes& most)
{
    if (check.quantity == ExpectedQuantity::Reaction) return most.force_of(check.dof.value());
    return check.component ? most.of(*check.component) : most.displacement_of(check.dof.value());
}

double result_of(const Expected& check, const CaseResult& result)
{
    switch (check.quantity) {
    case ExpectedQuantity::Displacement:
        if (check.member) return along_member(check, result.curve(*check.member));
        return result.displacement(check.node.value())[index(check.dof.value())];
    case ExpectedQuantity::Reaction: return result.reaction(check.node.value())[index(check.dof.value())];
    case ExpectedQuantity::SectionForce: return along_member(check, result.curve(check.member.value()));
    case ExpectedQuantity::Extreme: return extreme(check, result.curve(check.member.value()));
    default: break;
    }
    throw std::logic_error("verify: not a result of the linear analysis");
}

CheckOutcome verify_one(const Model& model, CaseMagnitudes* sizes, const Expected& check, const Translator& tr)
{
    const std::string what = describe_check(model, check, tr);
    const double tolerance = std::max(check.atol ? check.atol->value() : 0.0,
                                      check.rtol.value_or(default_rtol) * std::abs(check.value.value()));
    if (!is_linear(check))
        return {.what = what, .expected = check.value, .tolerance = tolerance, .skipped = SkipReason::AnalysisNotBuilt};
    if (sizes == nullptr) throw std::invalid_argument("verify: the model has checks of results, and none were given");
    const CaseId id = check.load_case.value_or(CaseId(0));
    CheckOutcome outcome = compared(what, check.value, result_of(check, sizes->results()[id]), tolerance);
    outcome.magnitude = magnitude_of(check, (*sizes)[id]);
    return outcome;
}

} // namespace

CheckOutcome compared(std::string what, double expected, double found, double tolerance)
{
    CheckOutcome outcome{.what = std::move(what), .expected = expected, .tolerance = tolerance, .skipped = {}};
    outcome.result = found;
    outcome.verdict = std::abs(found - expected) <= tolerance ? Verdict::Passed : Verdict::Failed;
    return outcome;
}

CheckCounts& CheckCounts::operator+=(const CheckCounts& other)
{
    passed += other.passed;
    failed += other.failed;
    skipped += other.skipped;
    return *this;
}

CheckCounts count(const std::vector<CheckOutcome>& outcomes)
{
    CheckCounts counts;
    for (const CheckOutcome& outcome : outcomes) {
        counts.passed += outcome.verdict == Verdict::Passed ? 1 : 0;
        counts.failed += outcome.verdict == Verdict::Failed ? 1 : 0;
        counts.skipped += outcome.verdict == Verdict::Skipped ? 1 : 0;
    }
    return counts;
}

bool needs_linear_analysis(const Model& model)
{
    return std::any_of(model.expected.begin(), model.expected.end(), is_linear);
}

std::vector<CheckOutcome> verify(const Model& model, const std::optional<Results>& results, const Translator& tr)
{
    std::vector<CheckOutcome> outcomes;
    std::optional<CaseMagnitudes> sizes;
    if (results) sizes.emplace(*results);
    for (const Expected& check : model.expected)
        outcomes.push_back(verify_one(model, sizes ? &*sizes : nullptr, check, tr));
    for (CheckOutcome& outcome : cross::check_block(model, tr)) outcomes.push_back(std::move(outcome));
    for (CheckOutcome& outcome : influence::check_block(model, tr)) outcomes.push_back(std::move(outcome));
    for (CheckOutcome& outcome : influence::check_train_block(model, tr)) outcomes.push_back(std::move(outcome));
    for (CheckOutcome& outcome : outcomes)
        if (outcome.result) outcome.result = without_rounding(*outcome.result, outcome.magnitude);
    return outcomes;
}

} // namespace femoop
