#include "femoop/io/plane/plane_verify.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string_view>

#include "femoop/model/quantity/number_text.h"
#include "femoop/plane/analysis/result_reader.h"

namespace femoop::plane {

namespace {

constexpr double usual_rtol = 1.0e-6;

bool is_linear(const PlaneExpected& check)
{
    return check.analysis == ExpectedAnalysis::Linear && check.quantity <= PlaneQuantity::Energy;
}

bool is_of_modes(const PlaneExpected& check) { return check.quantity == PlaneQuantity::Frequency; }

std::string_view quantity_word(PlaneQuantity quantity)
{
    static constexpr std::array<std::string_view, 10> words{
        translatable("displacement"), translatable("stress"),    translatable("strain"), translatable("extreme"),
        translatable("reaction"),     translatable("resultant"), translatable("energy"), translatable("frequency"),
        translatable("count"),        translatable("area")};
    return words[static_cast<std::size_t>(quantity)];
}

std::string place_words(const std::vector<Quantity>& at, std::size_t first)
{
    return "(" + number_text(at[first]) + ", " + number_text(at[first + 1]) + ")";
}

/// "case P: stress sx of point E"
std::string described(const PlaneModel& model, const PlaneExpected& check, const Translator& tr)
{
    std::string what;
    const auto add = [&](const std::string& words) { what += (what.empty() ? "" : " ") + words; };
    if (check.load_case) add(fill(tr("case {0}:"), {model.case_name(*check.load_case)}));
    if (check.analysis == ExpectedAnalysis::Modal) add(tr(translatable("modal")));
    add(tr(quantity_word(check.quantity)));
    if (check.component) add(std::string(name(*check.component)));
    if (!check.counted.empty()) add(check.counted);
    if (check.extreme) add(*check.extreme == ExtremeKind::Max ? "max" : "min");
    if (check.rank) add(std::to_string(*check.rank));
    if (check.point) add(fill(tr("of point {0}"), {model[*check.point].id}));
    if (check.curve) add(fill(tr("of curve {0}"), {model[*check.curve].id}));
    if (check.region) add(fill(tr("of region {0}"), {model[*check.region].id}));
    if (!check.at.empty()) add(fill(tr("at {0}"), {place_words(check.at, 0)}));
    if (!check.cut.empty())
        add(fill(tr("on the cut from {0} to {1}"), {place_words(check.cut, 0), place_words(check.cut, 2)}));
    if (check.read) {
        static constexpr std::array<std::string_view, 3> words{"smoothed", "element", "gauss"};
        add("(" + std::string(words[static_cast<std::size_t>(*check.read)]) + ")");
    }
    return what;
}

double tolerance_of(const PlaneExpected& check)
{
    return std::max(check.atol ? check.atol->value() : 0.0,
                    check.rtol.value_or(usual_rtol) * std::abs(check.value.value()));
}

} // namespace

bool needs_linear_analysis(const PlaneModel& model) { return std::ranges::any_of(model.expected, is_linear); }

std::size_t n_modes_needed(const PlaneModel& model)
{
    std::size_t n = 0;
    for (const PlaneExpected& check : model.expected)
        if (is_of_modes(check)) n = std::max(n, static_cast<std::size_t>(*check.rank));
    return n;
}

std::vector<CheckOutcome> verify(const PlaneModel& model, const PlaneFindings& findings,
                                 const std::optional<DrawnChecks>& drawn, const Translator& tr)
{
    std::vector<CheckOutcome> outcomes;
    std::map<CaseId, PlaneCase> cases; // what is recovered once serves all checks of a case
    for (std::size_t i = 0; i < model.expected.size(); ++i) {
        const PlaneExpected& check = model.expected[i];
        const std::string what = described(model, check, tr);
        const bool is_of_drawing = check.quantity == PlaneQuantity::Count || check.quantity == PlaneQuantity::Area;
        if (const auto found = is_of_drawing && drawn ? drawn->count_or_area(check) : std::nullopt) {
            outcomes.push_back(compared(what, check.value, *found, tolerance_of(check)));
            continue;
        }
        if (is_of_modes(check)) {
            if (!findings.modes)
                throw std::invalid_argument("verify: the model has checks of modes, and none were given");
            const NaturalMode& mode = findings.modes->modes[static_cast<std::size_t>(*check.rank) - 1];
            outcomes.push_back(compared(what, check.value, mode.frequency(), tolerance_of(check)));
            continue;
        }
        if (!is_linear(check)) {
            outcomes.push_back({.what = what,
                                .expected = check.value,
                                .tolerance = tolerance_of(check),
                                .skipped = SkipReason::AnalysisNotBuilt});
            continue;
        }
        if (!findings.results)
            throw std::invalid_argument("verify: the model has checks of results, and none were given");
        const PlaneResults& results = *findings.results;
        const CaseId id = check.load_case.value_or(CaseId(0));
        auto known = cases.find(id);
        if (known == cases.end()) known = cases.emplace(id, results[id]).first;
        const PlaneExpected& asked = drawn ? (*drawn->of_mesh)[i] : check;
        outcomes.push_back(compared(what, check.value, value_of(results, known->second, asked), tolerance_of(check)));
    }
    return outcomes;
}

} // namespace femoop::plane
