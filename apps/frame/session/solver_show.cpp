#include "apps/frame/session/solver_show.h"

#include <algorithm>

#include "femoop/io/results/solver_trace_text.h"

namespace frame {

using femoop::SolverTrace;
using ui::translatable;

namespace {

constexpr std::size_t most_nodes = 2000; // of more not even the counts are taken while the hand moves

std::optional<ui::Message> why_not_trace(const Session& session)
{
    if (!session.solution().results)
        return translatable("The structure cannot be solved, so no front walks: see the problems.");
    const std::size_t n = session.model().nodes.size();
    if (n <= most_nodes) return std::nullopt;
    return ui::Message(
        translatable(
            "The model has {count} nodes; the walk of the front is shown of systems of {most} unknowns or fewer."),
        {{"count", std::to_string(n)}, {"most", std::to_string(SolverTrace::most_unknowns)}});
}

} // namespace

void SolverShow::follow(const Session& session)
{
    const std::pair now{session.number(), session.generation()};
    if (made_for_ == now) return;
    made_for_ = now;
    why_none_ = why_not_trace(session);
    trace_.reset();
    if (!why_none_) trace_ = femoop::trace_solver(solved_model(session.model(), session.solution()));
    if (n_steps() > 0) go_to(step_); // else it waits for the front to come back
}

femoop::Ordering SolverShow::ordering() const
{
    if (ordering_) return *ordering_;
    return trace_ ? usual_ordering(*trace_) : femoop::Ordering::NestedDissection;
}

void SolverShow::choose(femoop::Ordering ordering)
{
    ordering_ = ordering;
    go_to(step_);
}

std::size_t SolverShow::n_steps() const
{
    return trace_ && trace_->has_details() ? trace_->walk(ordering()).fronts.size() : 0;
}

void SolverShow::go_to(std::size_t step)
{
    step_ = n_steps() == 0 ? 0 : std::min(step, n_steps() - 1);
    waited_ = 0.0;
}

void SolverShow::play()
{
    is_playing_ = n_steps() > 1;
    if (step_ + 1 == n_steps()) go_to(0);
}

void SolverShow::advance(double seconds)
{
    if (!is_playing_) return;
    waited_ += seconds;
    if (waited_ < seconds_per_step) return;
    go_to(step_ + 1);
    is_playing_ = step_ + 1 < n_steps();
}

} // namespace frame
