#include "apps/plane/document/analysed.h"

#include <utility>

#include "femoop/model/fault/errors_among.h"
#include "femoop/solver/progress.h"

namespace plane {

Analysed::Analysed(std::shared_ptr<const Solution> solution, const std::function<bool()>& is_cancelled,
                   const std::shared_ptr<const topology::SizeField>& sizes, AnalysisWatch* watch)
    : solution_(std::move(solution))
{
    mesh_and_solve(is_cancelled, sizes, watch);
}

void Analysed::mesh_and_solve(const std::function<bool()>& is_cancelled,
                              const std::shared_ptr<const topology::SizeField>& sizes, AnalysisWatch* watch)
{
    const auto is_given_up = [&] { return was_cancelled_ = was_cancelled_ || is_cancelled(); };
    mesh_.emplace(*solution_->drawing(), is_given_up, sizes);
    if (!mesh_->is_sound() || was_cancelled_) return leave_mesh(femoop::errors_among(mesh_->faults()));
    const std::size_t n_unknowns = 2 * mesh_->model().points.size();
    if (watch != nullptr) {
        watch->n_unknowns = n_unknowns;
        if (n_unknowns > watch->most_unknowns) {
            n_too_many_ = n_unknowns;
            return leave_mesh({});
        }
    }
    femoop::AnalysisOptions options;
    options.solver.progress = [&](double share) {
        if (watch != nullptr) watch->share = share;
        return !is_given_up();
    };
    femoop::plane::PlaneAnalysis analysis(options);
    try {
        solve(analysis);
    } catch (const femoop::Cancelled&) {
    }
    if (was_cancelled_) {
        refuse({});
        leave_mesh({});
    }
}

void Analysed::leave_mesh(std::vector<femoop::Fault> faults)
{
    faults_ = std::move(faults);
    mesh_.reset();
}

Analysed::Analysed(std::shared_ptr<const Solution> solution, Following& following)
    : solution_(std::move(solution)), is_following_(true)
{
    auto moved = following.mesh.in(*solution_->drawing());
    if (moved) mesh_.emplace(*solution_->drawing(), std::move(*moved));
    if (mesh_ && !mesh_->is_sound()) mesh_.reset();
    if (mesh_) solve(following.analysis);
}

void Analysed::refuse(std::vector<femoop::Fault> faults)
{
    results_.reset();
    cases_.clear();
    faults_ = std::move(faults);
}

namespace {

/// Whether anything moves or carries a force.
bool has_effect(const femoop::plane::PlaneCase& result)
{
    const femoop::plane::PlaneModel& mesh = result.structure().model();
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
        if (!result.displacement(femoop::NodeId(i)).isZero(0.0) || !result.reaction(femoop::NodeId(i)).isZero(0.0))
            return true;
    return false;
}

} // namespace

/// What there is to be solved: a drawing without load cases has a mesh alone.
void Analysed::solve(femoop::plane::PlaneAnalysis& analysis)
{
    if (mesh_->model().n_cases() == 0) return;
    try {
        results_ = analysis.solve_sound(mesh_->model());
        for (std::size_t i = 0; i < results_->n_cases(); ++i) cases_.push_back((*results_)[femoop::CaseId(i)]);
        for (const femoop::plane::PlaneCase& one : cases_) is_loaded_.push_back(has_effect(one));
    } catch (const femoop::MechanismError& error) {
        mechanisms_ = error.mechanisms();
        refuse(error.faults());
    } catch (const femoop::ModelError& error) { // what is wrong, or how the body can move
        refuse(error.faults());
    }
}

const femoop::plane::PlaneCase* Analysed::result(std::size_t load_case) const
{
    return load_case < cases_.size() ? &cases_[load_case] : nullptr;
}

} // namespace plane
