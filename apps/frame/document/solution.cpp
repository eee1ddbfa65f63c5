#include "apps/frame/document/solution.h"

#include <algorithm>
#include <utility>

#include "apps/frame/document/fault/place.h"
#include "femoop/analysis/linear_static.h"
#include "femoop/model/check/check.h"

namespace frame {

using femoop::CaseId;
using femoop::Combination;
using femoop::Fault;
using femoop::LoadCase;
using femoop::Model;

namespace {

/// What is wrong with each load case and combination by itself.
struct CaseTroubles {
    std::vector<Fault> faults;
    std::vector<femoop::Mechanism> mechanisms;
};
using Troubles = std::vector<CaseTroubles>;

bool is_faulty(const CaseTroubles& one) { return !one.faults.empty(); }

void empty(Model& model, CaseId id)
{
    if (id.index >= model.load_cases.size()) model.combinations[id.index - model.load_cases.size()].terms.clear();
    else model.load_cases[id.index] = LoadCase{.id = model.load_cases[id.index].id};
}

/// What is expected is compared with results, and hinders none.
Model without_faulty(const Model& model, const Troubles& troubles)
{
    Model rest = model;
    rest.expected.clear();
    for (std::size_t i = 0; i < troubles.size(); ++i)
        if (is_faulty(troubles[i])) empty(rest, CaseId(i));
    return rest;
}

void add_new(std::vector<Fault>& faults, const std::vector<Fault>& more)
{
    for (const Fault& fault : more)
        if (std::ranges::find(faults, fault) == faults.end()) faults.push_back(fault);
}

/// False where the structure itself has an error.
bool share_out(const std::vector<Fault>& faults, const Model& model, Troubles& troubles)
{
    for (const Fault& fault : faults) {
        if (!is_error(fault)) continue;
        const std::optional<FaultPlace> place = place_of(fault);
        if (place && place->steps.front().key == "expected") continue;
        const std::optional<CaseId> id = case_of(fault, model);
        if (!id) return false;
        troubles[id->index].faults.push_back(fault);
    }
    return true;
}

/// The combination alone among combinations, with those that it sums.
void keep_combination(Model& model, std::size_t place)
{
    const std::size_t n = model.load_cases.size();
    std::vector<bool> is_kept(model.combinations.size(), false);
    std::vector<std::size_t> open{place};
    while (!open.empty()) {
        const std::size_t i = open.back();
        open.pop_back();
        if (is_kept[i]) continue;
        is_kept[i] = true;
        for (const Combination::Term& term : model.combinations[i].terms)
            if (term.of.index >= n) open.push_back(term.of.index - n);
    }
    for (std::size_t i = 0; i < is_kept.size(); ++i)
        if (!is_kept[i]) model.combinations[i].terms.clear();
}

/// A model in which nothing but this case can go wrong.
Model alone(const Model& sound, CaseId id)
{
    Model trial = sound;
    const bool is_combination = id.index >= sound.load_cases.size();
    if (is_combination) keep_combination(trial, id.index - sound.load_cases.size());
    for (std::size_t i = 0; i < sound.n_cases() && !is_combination; ++i)
        if (i != id.index) empty(trial, CaseId(i));
    return trial;
}

/// Finds the cases that keep all from being solved together.
void blame(femoop::LinearStatic& analysis, const Model& model, Troubles& troubles)
{
    for (std::size_t i = 0; i < troubles.size(); ++i) {
        if (is_faulty(troubles[i])) continue;
        try {
            analysis.solve(alone(without_faulty(model, troubles), CaseId(i)));
        } catch (const femoop::MechanismError& error) {
            troubles[i] = {error.faults(), error.mechanisms()};
        } catch (const femoop::ModelError& error) {
            troubles[i].faults = error.faults();
        }
    }
}

femoop::Results solve_cases(const Model& model, Troubles& troubles)
{
    const Model sound = without_faulty(model, troubles);
    femoop::LinearStatic analysis(sound);
    try {
        return analysis.solve(sound);
    } catch (const femoop::ModelError&) {
        blame(analysis, model, troubles);
        if (std::ranges::all_of(troubles, is_faulty)) throw;
        return analysis.solve(without_faulty(model, troubles));
    }
}

/// Combinations get the faults of the cases that they sum.
std::vector<BlankCase> blank_cases(const Model& model, const Troubles& troubles)
{
    std::vector<BlankCase> all;
    for (std::size_t i = 0; i < troubles.size(); ++i)
        all.push_back({CaseId(i), troubles[i].faults, troubles[i].mechanisms});
    const std::size_t n = model.load_cases.size();
    for (bool grows = true; grows;) {
        grows = false;
        for (std::size_t i = 0; i < model.combinations.size(); ++i) {
            const std::size_t before = all[n + i].faults.size();
            for (const Combination::Term& term : model.combinations[i].terms)
                if (term.of.index < all.size()) add_new(all[n + i].faults, all[term.of.index].faults);
            grows = grows || all[n + i].faults.size() > before;
        }
    }
    std::erase_if(all, [](const BlankCase& one) { return one.faults.empty(); });
    return all;
}

void solve_into(Solution& solution, const Model& model, Troubles troubles)
{
    try {
        femoop::Results results = solve_cases(model, troubles);
        add_new(solution.faults, results.warnings());
        solution.blank = blank_cases(model, troubles);
        for (const BlankCase& one : solution.blank) add_new(solution.faults, one.faults);
        const bool is_all_blank = !solution.blank.empty() && solution.blank.size() == model.n_cases();
        if (!is_all_blank) solution.results = std::move(results);
    } catch (const femoop::MechanismError& error) {
        solution.mechanisms = error.mechanisms();
        add_new(solution.faults, error.faults());
    } catch (const femoop::ModelError& error) {
        add_new(solution.faults, error.faults());
    }
}

} // namespace

bool Solution::has_errors() const { return std::ranges::any_of(faults, femoop::is_error); }

const BlankCase* Solution::blank_case(CaseId id) const
{
    const auto found = std::ranges::find(blank, id, &BlankCase::id);
    return found != blank.end() ? &*found : nullptr;
}

std::vector<CaseId> Solution::solved_cases() const
{
    std::vector<CaseId> solved;
    for (std::size_t i = 0; i < results->n_cases(); ++i)
        if (blank_case(CaseId(i)) == nullptr) solved.emplace_back(i);
    return solved;
}

Solution solve(const Document& document)
{
    Solution solution;
    solution.faults = named(femoop::check(document.model), document.model);
    Troubles troubles(document.model.n_cases());
    if (share_out(solution.faults, document.model, troubles)) solve_into(solution, document.model, std::move(troubles));
    return solution;
}

Model without_blank_cases(const Model& model, const Solution& solution)
{
    Model rest = model;
    for (const BlankCase& one : solution.blank) empty(rest, one.id);
    return rest;
}

Model solved_model(const Model& model, const Solution& solution)
{
    Model solved = without_blank_cases(model, solution);
    solved.expected.clear();
    return solved;
}

} // namespace frame
