#include "femoop/methods/cross/turns.h"

#include <algorithm>
#include <cmath>

namespace femoop::cross {

namespace {

/// Writes a sheet on, turn by turn.
class Writer {
public:
    Writer(const Problem& problem, Sheet& sheet, int digits) : problem_(problem), sheet_(sheet), digits_(digits) {}

    void take(const Turn& turn)
    {
        Step step{.joint = turn, .first = sheet_.changes.size()};
        std::vector<Change> carried;
        if (turn) release(*turn, carried);
        else
            for (const JointId joint : problem_.balanced_joints()) release(joint, carried);
        step.carried = sheet_.changes.size();
        for (const Change& change : carried) add(change);
        step.last = sheet_.changes.size();
        step.largest_unbalance = largest_unbalance(sheet_.end);
        sheet_.steps.push_back(step);
    }

private:
    // What is carried over waits: where all joints turn at once none of them feels it yet.
    void release(JointId joint, std::vector<Change>& carried)
    {
        State& state = sheet_.end;
        const Release release = release_of(problem_, state, joint, digits_);
        const JointId image = problem_.mirror ? problem_.mirror->joints[joint.index] : joint;
        state.rotations[joint.index] -= state.unbalance[joint.index] / problem_[joint].stiffness;
        if (image != joint) state.rotations[image.index] = problem_.mirror->sign() * state.rotations[joint.index];
        for (const Change& change : release.balance) add(change);
        if (digits_ == 0) state.unbalance[joint.index] = state.unbalance[image.index] = 0.0;
        carried.insert(carried.end(), release.carry_over.begin(), release.carry_over.end());
    }

    void add(const Change& change)
    {
        sheet_.changes.push_back(change);
        sheet_.end.moments[change.end.index] += change.value;
        if (const std::optional<JointId> joint = problem_[change.end].joint)
            sheet_.end.unbalance[joint->index] += change.value;
    }

    const Problem& problem_;
    Sheet& sheet_;
    int digits_;
};

double tolerance_of(const Loading& loading, const Procedure& procedure)
{
    constexpr double usual = 1e-3; // of the largest fixed-end moment, as in `distribute`
    double largest = 0.0;
    for (const double moment : loading.fixed_end) largest = std::max(largest, std::abs(moment));
    return procedure.tolerance.value_or(usual * largest);
}

std::vector<JointId> listed(const Model& model, const Problem& problem, const Procedure& procedure)
{
    std::vector<JointId> joints = procedure.joints;
    std::erase_if(joints, [&](JointId joint) { return !problem.is_balanced(joint); });
    if (procedure.order == Order::Listed && !joints.empty()) return joints;
    joints = problem.balanced_joints();
    if (procedure.order == Order::LeftToRight)
        std::ranges::stable_sort(joints, {}, [&](JointId j) { return model[problem[j].node].at[0].value(); });
    return joints;
}

} // namespace

Sheet sheet_of(const Problem& problem, const Loading& loading, std::span<const Turn> turns, const Procedure& procedure)
{
    Sheet sheet;
    sheet.tolerance = tolerance_of(loading, procedure);
    sheet.start = sheet.end = locked_state(problem, loading, procedure.digits);
    Writer writer(problem, sheet, procedure.digits);
    for (const Turn& turn : turns) writer.take(turn);
    sheet.is_balanced = largest_unbalance(sheet.end) <= sheet.tolerance;
    return sheet;
}

Turn next_turn(const Model& model, const Problem& problem, const Sheet& sheet, const Procedure& procedure)
{
    if (procedure.order == Order::AllAtOnce) return std::nullopt;
    if (procedure.order == Order::Largest) return worst_joint(problem, sheet.end);
    const std::vector<JointId> joints = listed(model, problem, procedure);
    const Turn last = sheet.steps.empty() ? Turn{} : sheet.steps.back().joint;
    const auto at = last ? std::ranges::find(joints, *last) : joints.end();
    return at == joints.end() || at + 1 == joints.end() ? joints.front() : *(at + 1);
}

} // namespace femoop::cross
