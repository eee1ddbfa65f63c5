#include "femoop/methods/cross/distribution.h"

#include <algorithm>
#include <cmath>

#include "femoop/methods/cross/rounding.h"
#include "femoop/model/fault/fault.h"
#include "femoop/model/quantity/number_text.h"

namespace femoop::cross {

namespace {

constexpr double usual_tolerance = 1e-3; // of the largest fixed-end moment

/// Works on a state in place.
class Worker {
public:
    Worker(const Problem& problem, const Loading& loading, int digits)
        : problem_(problem),
          digits_(digits),
          factors_(factors_of(problem, digits)),
          state_(locked_state(problem, loading, digits)),
          loads_(loading.joint_load)
    {}
    Worker(const Problem& problem, State state, int digits)
        : problem_(problem), digits_(digits), factors_(factors_of(problem, digits)), state_(std::move(state))
    {
        for (std::size_t j = 0; j < problem.joints.size(); ++j)
            loads_.push_back(sum_of(JointId(j)) - state_.unbalance[j]);
    }

    const State& state() const { return state_; }
    State take() { return std::move(state_); }
    double largest() const { return largest_unbalance(state_); }

    void balance(JointId id, std::vector<Change>& changes)
    {
        const std::size_t first = changes.size();
        turn(id, changes);
        if (problem_.mirror && problem_.mirror->joints[id.index] != id) turn_image(id, first, changes);
    }

    void balance_all(std::vector<Change>& changes)
    {
        for (const JointId joint : problem_.balanced_joints()) balance(joint, changes);
    }

    /// Carries over what the balances in [first, carried) send.
    void carry(std::size_t first, std::vector<Change>& changes)
    {
        const std::size_t carried = changes.size();
        for (std::size_t i = first; i < carried; ++i) {
            const End& end = problem_[changes[i].end];
            if (end.carry_over == 0.0) continue;
            const double value = rounded(changes[i].value * end.carry_over, digits_);
            changes.push_back({*end.far, value + 0.0});
            state_.moments[end.far->index] += value;
            if (const std::optional<JointId> far = problem_[*end.far].joint) state_.unbalance[far->index] += value;
        }
    }

private:
    void turn(JointId id, std::vector<Change>& changes)
    {
        const Joint& joint = problem_[id];
        const double unbalance = state_.unbalance[id.index];
        state_.rotations[id.index] -= unbalance / joint.stiffness;
        for (const EndId e : joint.ends) {
            const double value = rounded(-unbalance * factors_[e.index], digits_);
            changes.push_back({e, value + 0.0});
            state_.moments[e.index] += value;
        }
        state_.unbalance[id.index] = digits_ > 0 ? sum_of(id) - loads_[id.index] : 0.0;
    }

    /// The image of a joint turns with it, and what its turn wrote in [first, end) is written there too.
    void turn_image(JointId joint, std::size_t first, std::vector<Change>& changes)
    {
        const Mirror& mirror = *problem_.mirror;
        const std::size_t last = changes.size();
        for (std::size_t i = first; i < last; ++i) {
            const Change own = changes[i], image{mirror.ends[own.end.index], mirror.sign() * own.value + 0.0};
            changes.push_back(image);
            state_.moments[image.end.index] += image.value;
        }
        const std::size_t image = mirror.joints[joint.index].index;
        state_.rotations[image] = mirror.sign() * state_.rotations[joint.index];
        state_.unbalance[image] = mirror.sign() * state_.unbalance[joint.index];
    }

    double sum_of(JointId joint) const
    {
        double sum = 0.0;
        for (const EndId e : problem_[joint].ends) sum += state_.moments[e.index];
        return sum;
    }

    const Problem& problem_;
    int digits_;
    std::vector<double> factors_;
    State state_;
    std::vector<double> loads_;
};

/// The order in which joints have their turn.
class Turns {
public:
    Turns(const Model& model, const Problem& problem, const Procedure& procedure)
        : problem_(problem), order_(procedure.order)
    {
        if (order_ == Order::Listed) joints_ = procedure.joints;
        std::erase_if(joints_, [&](JointId joint) { return !problem.is_balanced(joint); });
        if (joints_.empty()) joints_ = problem.balanced_joints();
        if (order_ == Order::LeftToRight)
            std::ranges::stable_sort(joints_, {}, [&](JointId j) { return model[problem[j].node].at[0].value(); });
    }

    JointId next(const State& state)
    {
        if (order_ == Order::Largest) return *worst_joint(problem_, state);
        const JointId joint = joints_[at_];
        at_ = (at_ + 1) % joints_.size();
        return joint;
    }

private:
    const Problem& problem_;
    Order order_;
    std::vector<JointId> joints_;
    std::size_t at_ = 0;
};

double usual_tolerance_of(const Loading& loading)
{
    double largest = 0.0;
    for (const double moment : loading.fixed_end) largest = std::max(largest, std::abs(moment));
    return usual_tolerance * largest;
}

void work(Sheet& sheet, Worker& worker, Turns& turns, const Procedure& procedure)
{
    const auto is_done = [&] {
        return procedure.balances ? sheet.steps.size() >= *procedure.balances : worker.largest() <= sheet.tolerance;
    };
    while (!is_done() && sheet.steps.size() < procedure.most_steps) {
        Step step{.joint = {}, .first = sheet.changes.size()};
        if (procedure.order == Order::AllAtOnce) worker.balance_all(sheet.changes);
        else worker.balance(*(step.joint = turns.next(worker.state())), sheet.changes);
        step.carried = sheet.changes.size();
        const bool is_last = procedure.balances && sheet.steps.size() + 1 == *procedure.balances;
        step.is_carried = !(is_last && procedure.ends_with_balance);
        if (step.is_carried) worker.carry(step.first, sheet.changes);
        step.last = sheet.changes.size();
        step.largest_unbalance = worker.largest();
        sheet.steps.push_back(step);
    }
}

} // namespace

std::vector<double> factors_of(const Problem& problem, int digits)
{
    std::vector<double> factors;
    factors.reserve(problem.ends.size());
    for (const End& end : problem.ends) factors.push_back(rounded(end.factor, digits));
    return factors;
}

State locked_state(const Problem& problem, const Loading& loading, int digits)
{
    State state{
        .moments = loading.fixed_end, .rotations = std::vector<double>(problem.joints.size(), 0.0), .unbalance = {}};
    for (double& moment : state.moments) moment = rounded(moment, digits) + 0.0;
    for (std::size_t e = 0; problem.mirror && e < state.moments.size(); ++e)
        if (problem.is_on_sheet(EndId(e)) && !problem.is_on_sheet(problem.mirror->ends[e]))
            state.moments[problem.mirror->ends[e].index] = problem.mirror->sign() * state.moments[e] + 0.0;
    for (std::size_t j = 0; j < problem.joints.size(); ++j) {
        double unbalance = -loading.joint_load[j];
        for (const EndId e : problem.joints[j].ends) unbalance += state.moments[e.index];
        state.unbalance.push_back(unbalance);
    }
    return state;
}

Release release_of(const Problem& problem, const State& state, JointId joint, int digits)
{
    Worker worker(problem, state, digits);
    Release release;
    worker.balance(joint, release.balance);
    std::vector<Change> all = release.balance;
    worker.carry(0, all);
    release.carry_over.assign(all.begin() + static_cast<std::ptrdiff_t>(release.balance.size()), all.end());
    return release;
}

State balance(const Problem& problem, const State& state, JointId joint, int digits)
{
    Worker worker(problem, state, digits);
    std::vector<Change> changes;
    worker.balance(joint, changes);
    worker.carry(0, changes);
    return worker.take();
}

std::optional<JointId> worst_joint(const Problem& problem, const State& state)
{
    std::optional<JointId> worst;
    for (std::size_t j = 0; j < state.unbalance.size(); ++j)
        if (problem.is_balanced(JointId(j)) &&
            (!worst || std::abs(state.unbalance[j]) > std::abs(state.unbalance[worst->index])))
            worst = JointId(j);
    return worst;
}

double largest_unbalance(const State& state)
{
    double largest = 0.0;
    for (const double unbalance : state.unbalance) largest = std::max(largest, std::abs(unbalance));
    return largest;
}

Sheet try_to_distribute(const Model& model, const Problem& problem, const Loading& loading, const Procedure& procedure)
{
    Sheet sheet;
    sheet.tolerance = procedure.tolerance.value_or(usual_tolerance_of(loading));
    Worker worker(problem, loading, procedure.digits);
    sheet.start = worker.state();
    Turns turns(model, problem, procedure);
    if (!problem.balanced_joints().empty()) work(sheet, worker, turns, procedure);
    sheet.is_balanced = worker.largest() <= sheet.tolerance;
    sheet.end = worker.take();
    return sheet;
}

Sheet distribute(const Model& model, const Problem& problem, const Loading& loading, const Procedure& procedure)
{
    Sheet sheet = try_to_distribute(model, problem, loading, procedure);
    if (sheet.is_balanced || procedure.balances) return sheet;
    const auto moment = [&](double value) { return quantity_text(rounded(value, 3), dimension::moment, model.units); };
    throw ModelError({{FaultKind::CrossSteps,
                       {std::to_string(sheet.steps.size()), moment(largest_unbalance(sheet.end)),
                        model[problem[*worst_joint(problem, sheet.end)].node].id, moment(sheet.tolerance)}}});
}

State state_after(const Problem& problem, const Sheet& sheet, std::size_t n)
{
    State state = sheet.start;
    const auto add = [&](const Change& change) {
        state.moments[change.end.index] += change.value;
        if (const std::optional<JointId> joint = problem[change.end].joint)
            state.unbalance[joint->index] += change.value;
    };
    for (const Step& step : std::span(sheet.steps).first(std::min(n, sheet.steps.size()))) {
        const auto turn = [&](JointId j) {
            state.rotations[j.index] -= state.unbalance[j.index] / problem[j].stiffness;
            if (problem.mirror && problem.mirror->joints[j.index] != j)
                state.rotations[problem.mirror->joints[j.index].index] = problem.mirror->sign() *
                                                                         state.rotations[j.index];
        };
        if (step.joint) turn(*step.joint);
        else std::ranges::for_each(problem.balanced_joints(), turn);
        std::ranges::for_each(sheet.balanced(step), add);
        std::ranges::for_each(sheet.carried_over(step), add);
    }
    return state;
}

std::vector<double> drift(const Problem& problem, const Loading& loading, const Sheet& sheet)
{
    Worker worker(problem, loading, 0);
    std::vector<Change> changes;
    for (const Step& step : sheet.steps) {
        changes.clear();
        if (step.joint) worker.balance(*step.joint, changes);
        else worker.balance_all(changes);
        if (step.is_carried) worker.carry(0, changes);
    }
    std::vector<double> difference = sheet.end.moments;
    for (std::size_t e = 0; e < difference.size(); ++e) difference[e] -= worker.state().moments[e];
    return difference;
}

std::vector<Row> rows_of(const Problem& problem, const Sheet& sheet)
{
    const std::size_t n = problem.ends.size();
    std::vector<Row> rows;
    rows.push_back({RowKind::FixedEnd, {}, sheet.start.moments});
    const auto add = [&](RowKind kind, std::optional<JointId> joint, std::span<const Change> changes) {
        Row row{kind, joint, std::vector<double>(n, 0.0)};
        for (const Change& change : changes) row.values[change.end.index] += change.value;
        rows.push_back(std::move(row));
    };
    for (const Step& step : sheet.steps) {
        add(RowKind::Balance, step.joint, sheet.balanced(step));
        if (step.is_carried) add(RowKind::CarryOver, {}, sheet.carried_over(step));
    }
    rows.push_back({RowKind::Total, {}, sheet.end.moments});
    return rows;
}

std::vector<double> convergence(const Sheet& sheet)
{
    std::vector<double> history{largest_unbalance(sheet.start)};
    for (const Step& step : sheet.steps) history.push_back(step.largest_unbalance);
    return history;
}

std::optional<double> rate(const Problem& problem, const Sheet& sheet)
{
    const std::vector<double> history = convergence(sheet);
    const bool is_at_once = !sheet.steps.empty() && !sheet.steps.front().joint;
    const std::size_t round = is_at_once ? 1 : problem.balanced_joints().size();
    const std::size_t last = history.size() - 1, first = last / 2;
    if (last - first < round || history[first] == 0.0 || history[last] == 0.0) return std::nullopt;
    const double rounds = static_cast<double>(last - first) / static_cast<double>(round);
    return std::pow(history[last] / history[first], 1.0 / rounds);
}

} // namespace femoop::cross
