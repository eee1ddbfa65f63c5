#include "apps/cli/mohr_criterion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "apps/cli/console.h"
#include "femoop/methods/mohr/criterion_names.h"
#include "femoop/methods/mohr/typed_components.h"
#include "femoop/model/fault/fault.h"
#include "femoop/model/quantity/number_text.h"

namespace cli {

namespace {

namespace fm = femoop::mohr;

/// What a strength is counted in: the stresses that it is compared with.
std::string stress_unit(const MohrProblem& problem)
{
    return fm::is_strain(problem.state.kind) ? problem.stress_unit : problem.unit;
}

std::string needed(fm::Criterion criterion)
{
    std::string list;
    for (const fm::StrengthName& strength : fm::strengths_of(criterion))
        list += (list.empty() ? "" : ",") + std::string(strength.word) + "=...";
    return list;
}

class StrengthReader {
public:
    StrengthReader(const MohrProblem& problem, const MohrWords& words, const ui::Catalogue& tr)
        : problem_(problem), words_(words), tr_(tr)
    {}

    fm::Strength read() const
    {
        const auto wanted = fm::strengths_of(*problem_.criterion);
        if (words_.strength.size() != wanted.size()) throw wrong_list();
        fm::Strength strength;
        for (const fm::StrengthName& name : wanted) strength.*name.value = number(name);
        if (const auto fault = fm::why_not(*problem_.criterion, strength)) throw flawed(*fault, strength);
        return strength;
    }

private:
    UsageError wrong_list() const
    {
        return UsageError(tr_("--strength: {criterion} wants {list}",
                              {{"criterion", words_.criterion}, {"list", needed(*problem_.criterion)}}));
    }

    double number(const fm::StrengthName& name) const
    {
        const std::string key = std::string(name.word) + "=";
        const auto at = std::ranges::find_if(words_.strength, [&](const auto& word) { return word.starts_with(key); });
        if (at == words_.strength.end()) throw wrong_list();
        const std::string unit = name.is_stress ? stress_unit(problem_) : "";
        const std::array texts{unit.empty() ? std::string("0") : "1 " + unit, at->substr(key.size())};
        const std::array<std::string_view, 2> parts{name.word, name.word};
        const auto dimension = name.is_stress ? femoop::dimension::stress : femoop::dimension::none;
        const auto found = fm::parse_components(texts, parts, "--strength", dimension);
        if (const auto* fault = std::get_if<femoop::Fault>(&found)) throw UsageError(femoop::message(*fault, tr_));
        const double value = std::get<fm::Components>(found).values.back();
        return name.word == "phi" ? value * std::numbers::pi / 180.0 : value;
    }

    UsageError flawed(const fm::StrengthFault& fault, const fm::Strength& strength) const
    {
        std::string_view name;
        for (const fm::StrengthName& candidate : fm::strengths_of(*problem_.criterion))
            if (candidate.value == fault.value) name = candidate.word;
        const bool is_angle = fault.flaw == fm::StrengthFlaw::AngleOutOfRange;
        const double found = strength.*fault.value * (is_angle ? 180.0 / std::numbers::pi : 1.0);
        const std::string wanted = is_angle ? tr_("an angle of at least 0 and less than 90 degrees")
                                   : fault.flaw == fm::StrengthFlaw::AboveOne ? tr_("a number of at most 1")
                                                                              : tr_("a number greater than 0");
        return UsageError(
            tr_("{option}: found {found}; wanted {wanted}", {{"option", "--strength " + std::string(name)},
                                                             {"found", femoop::number_text(found)},
                                                             {"wanted", wanted}}));
    }

    const MohrProblem& problem_;
    const MohrWords& words_;
    const ui::Catalogue& tr_;
};

fm::Criterion criterion_of(const MohrWords& words, const ui::Catalogue& tr)
{
    if (const auto criterion = fm::criterion_named(words.criterion)) return *criterion;
    std::string list;
    for (const fm::Criterion criterion : fm::all_criteria)
        list += (list.empty() ? "" : ", ") + std::string(fm::word(criterion));
    throw UsageError(
        tr("{option}: found {found}; wanted {wanted}", {{"option", "--criterion"},
                                                        {"found", "\"" + words.criterion + "\""},
                                                        {"wanted", tr("one of {list}", {{"list", list}})}}));
}

} // namespace

void take_criterion(MohrProblem& problem, const MohrWords& words, const ui::Catalogue& tr)
{
    if (words.criterion.empty()) {
        if (!words.strength.empty()) throw UsageError(tr("--strength: wanted with --criterion alone; take it away"));
        return;
    }
    if (problem.state.kind == fm::Kind::Inertia)
        throw UsageError(tr("--criterion: second moments of area do not fail; take it away"));
    if (fm::is_strain(problem.state.kind) && !problem.state.E)
        throw UsageError(tr("--criterion: it judges stresses; give --E and --nu"));
    problem.criterion = criterion_of(words, tr);
    problem.strength = StrengthReader(problem, words, tr).read();
}

} // namespace cli
