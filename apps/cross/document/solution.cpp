#include "apps/cross/document/solution.h"

#include <algorithm>

#include "femoop/analysis/mechanism.h"
#include "femoop/methods/cross/prop_forces.h"
#include "femoop/methods/cross/symmetry.h"
#include "femoop/model/check/check.h"
#include "femoop/model/fault/errors_among.h"
#include "femoop/model/fault/fault.h"

namespace cross {

namespace fc = femoop::cross;

namespace {

void add(std::vector<femoop::Fault>& faults, const femoop::ModelError& error)
{
    faults.insert(faults.end(), error.faults().begin(), error.faults().end());
}

fc::Procedure procedure_of(const Document& document, const fc::Problem& problem)
{
    const Method& method = document.method;
    fc::Procedure procedure{.order = method.order, .tolerance = method.tolerance, .digits = method.digits};
    for (const std::string& name : method.joints) {
        const auto node = document.model.find_node(name);
        if (const auto joint = node ? problem.joint_at(*node) : std::nullopt) procedure.joints.push_back(*joint);
    }
    return procedure;
}

/// Tries one thing that may be missing, and keeps why.
template <class Work> void attempt(Task& task, const Work& work)
{
    try {
        work();
    } catch (const femoop::ModelError& error) {
        for (const femoop::Fault& fault : error.faults())
            if (std::ranges::find(task.remarks, fault) == task.remarks.end()) task.remarks.push_back(fault);
    }
}

void complete(Task& task, const femoop::Model& model, SolveMode mode)
{
    attempt(task, [&] { task.all = fc::superpose(model, task.problem, task.procedure); });
    if (!task.all) return;
    attempt(task, [&] { task.comparison = fc::compare(model, task.problem, task.all->moments); });
    if (mode == SolveMode::Full) attempt(task, [&] { task.kani = fc::kani(model, task.problem); });
    attempt(task, [&] { task.equations = fc::slope_deflection(model, task.problem); });
    attempt(task,
            [&] { task.balanced = fc::state_results(model, task.problem, fc::locks_of(task.problem, *task.all)); });
}

Task task_of(const Document& document)
{
    const Method& method = document.method;
    Task task{.problem = fc::problem_of(document.model, method.load_case, method.far_ends)};
    try {
        task.by_halves = fc::by_halves(document.model, task.problem);
    } catch (const femoop::ModelError& error) {
        task.why_not_by_halves = error.faults().front();
    }
    if (method.extent == fc::Extent::Half && !document.pupil) {
        if (task.by_halves) task.problem = *task.by_halves;
        else task.remarks.push_back(*task.why_not_by_halves);
    }
    task.procedure = procedure_of(document, task.problem);
    return task;
}

std::vector<double> between(const std::vector<double>& a, const std::vector<double>& b, double share)
{
    std::vector<double> middle = b;
    for (std::size_t i = 0; i < middle.size() && i < a.size(); ++i) middle[i] = a[i] + share * (b[i] - a[i]);
    return middle;
}

} // namespace

const fc::Sheet* Solution::sheet(const Document& document) const
{
    return document.stage < sheets.size() ? &sheets[document.stage] : nullptr;
}

Solution solve(const Document& document, SolveMode mode)
{
    Solution solution{.faults = errors_among(femoop::check(document.model))};
    if (!solution.faults.empty()) return solution;
    try {
        Task task = task_of(document);
        complete(task, document.model, mode);
        solution.task = std::move(task);
    } catch (const femoop::ModelError& error) {
        add(solution.faults, error);
    }
    work(solution, document);
    return solution;
}

void work(Solution& solution, const Document& document)
{
    solution.sheets.clear();
    solution.held.clear();
    if (!solution.task) return;
    const Task& task = *solution.task;
    fc::PropForces forces(task.problem);
    for (std::size_t stage = 0; stage < task.n_sheets(); ++stage) {
        const auto turns = stage < document.plays.size() ? document.plays[stage].turns()
                                                         : std::vector<TurnTree::Turn>{};
        solution.sheets.push_back(
            fc::sheet_of(task.problem.of_sheet(stage), task.loading(stage), turns, task.procedure));
        solution.held.push_back(forces.at_end_of(solution.sheets.back(), stage));
    }
}

fc::Locks present_locks(const Document& document, const Solution& solution, double phase)
{
    const fc::Problem& problem = solution.task->problem;
    const fc::Sheet* sheet = solution.sheet(document);
    if (sheet == nullptr) return fc::locks_of(problem, *solution.task->all);
    const auto locks = [&](const fc::State& state) {
        return document.stage == 0 ? fc::locks_of(problem, state) : fc::locks_of(problem, state, document.stage - 1);
    };
    fc::Locks now = locks(sheet->end);
    if (phase >= 1.0 || sheet->steps.empty()) return now;
    const fc::Locks before = locks(fc::state_after(solution.sheet_problem(document), *sheet, sheet->steps.size() - 1));
    now.rotations = between(before.rotations, now.rotations, phase);
    now.dead_moments = between(before.dead_moments, now.dead_moments, phase);
    return now;
}

std::vector<double> present_moments(const Document& document, const Solution& solution)
{
    const fc::Sheet* sheet = solution.sheet(document);
    return sheet != nullptr ? sheet->end.moments : solution.task->all->moments;
}

std::vector<double> held_by_props(const Document& document, const Solution& solution)
{
    return solution.held[document.stage];
}

std::optional<TurnTree::Turn> next_turn(const Document& document, const Solution& solution)
{
    const fc::Sheet* sheet = solution.sheet(document);
    if (sheet == nullptr || solution.sheet_problem(document).balanced_joints().empty()) return std::nullopt;
    return fc::next_turn(document.model, solution.sheet_problem(document), *sheet, solution.task->procedure);
}

} // namespace cross
