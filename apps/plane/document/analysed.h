#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "apps/plane/discretize/following_mesh.h"
#include "apps/plane/discretize/meshed_drawing.h"
#include "apps/plane/document/solution.h"
#include "femoop/analysis/mechanism.h"
#include "femoop/plane/analysis/plane_analysis.h"
#include "femoop/plane/analysis/plane_results.h"

namespace plane {

/// What goes along while a drawing is dragged: a mesh whose elements stay, so that its equations are ordered once.
struct Following {
    /// \pre the solution has a drawing, and the mesh is its
    Following(std::shared_ptr<const Solution> of, const discretize::RegionMesh& of_drawing)
        : solution(std::move(of)), mesh(*solution->drawing(), of_drawing)
    {}

    std::shared_ptr<const Solution> solution;
    discretize::FollowingMesh mesh;
    femoop::plane::PlaneAnalysis analysis{};
};

/// What an analysis tells while it goes on, and hears, from thread to thread.
struct AnalysisWatch {
    std::size_t most_unknowns = std::numeric_limits<std::size_t>::max(); ///< more are not solved for
    std::atomic<bool> is_given_up = false;
    std::atomic<std::size_t> n_unknowns = 0; ///< 0 until there is a mesh
    std::atomic<double> share = 0.0;         ///< of the work that solving is
};

/// The mesh of a sound drawing, and what its loads do to it: a pure function of the drawing, found where it is asked
/// for.
class Analysed {
public:
    /// \param is_cancelled  asked now and then while the mesh is made and solved
    /// \param sizes  in place of the drawing's own; null: those  \param watch  null: nobody
    /// \pre solution->is_sound()
    Analysed(std::shared_ptr<const Solution> solution, const std::function<bool()>& is_cancelled,
             const std::shared_ptr<const topology::SizeField>& sizes = {}, AnalysisWatch* watch = nullptr);
    /// Given up before there was anything.
    static Analysed given_up(std::shared_ptr<const Solution> solution) { return Analysed(std::move(solution)); }
    /// With the mesh of another drawing that goes along as far as this one; without a mesh where it cannot.
    Analysed(std::shared_ptr<const Solution> solution, Following& following);

    const std::shared_ptr<const Solution>& solution() const { return solution_; } ///< that it is of
    const PlaneModel* mesh() const { return mesh_ ? &mesh_->model() : nullptr; }
    const discretize::MeshedDrawing& meshed() const { return *mesh_; } ///< \pre there is a mesh
    bool is_following() const { return is_following_; }                ///< its mesh is another drawing's
    const femoop::plane::PlaneResults* results() const { return results_ ? &*results_ : nullptr; }
    /// Of a case, with all that was recovered of it; null where there are no results.
    const femoop::plane::PlaneCase* result(std::size_t load_case) const;
    /// Why there is no mesh, or why it cannot be solved.
    const std::vector<femoop::Fault>& faults() const { return faults_; }
    /// Where it can move without strain: how, each with its sentence among the faults. Of the mesh's points.
    const std::vector<femoop::Mechanism>& mechanisms() const { return mechanisms_; }
    /// A load, heat or a settlement does something to it. \pre the case has a result
    bool is_loaded(std::size_t load_case) const { return is_loaded_[load_case]; }
    bool was_cancelled() const { return was_cancelled_; }
    /// Of a mesh that has more than are solved for, and was left; nothing where it has not.
    std::optional<std::size_t> n_unknowns_too_many() const { return n_too_many_; }

private:
    explicit Analysed(std::shared_ptr<const Solution> solution) : solution_(std::move(solution)), was_cancelled_(true)
    {}
    void mesh_and_solve(const std::function<bool()>& is_cancelled,
                        const std::shared_ptr<const topology::SizeField>& sizes, AnalysisWatch* watch);
    void leave_mesh(std::vector<femoop::Fault> faults);
    void solve(femoop::plane::PlaneAnalysis& analysis);
    void refuse(std::vector<femoop::Fault> faults);

    std::shared_ptr<const Solution> solution_;
    std::optional<discretize::MeshedDrawing> mesh_;
    std::optional<femoop::plane::PlaneResults> results_;
    std::vector<femoop::plane::PlaneCase> cases_;
    std::vector<bool> is_loaded_; ///< of each case
    std::vector<femoop::Mechanism> mechanisms_;
    std::vector<femoop::Fault> faults_;
    std::optional<std::size_t> n_too_many_;
    bool was_cancelled_ = false, is_following_ = false;
};

} // namespace plane
