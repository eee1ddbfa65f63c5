#pragma once

#include <functional>
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

/// The mesh of a sound drawing, and what its loads do to it: a pure function of the drawing, found where it is asked
/// for.
class Analysed {
public:
    /// \param is_cancelled  asked now and then while the mesh is made
    /// \param sizes  in place of the drawing's own; null: those  \pre solution->is_sound()
    Analysed(std::shared_ptr<const Solution> solution, const std::function<bool()>& is_cancelled,
             const std::shared_ptr<const topology::SizeField>& sizes = {});
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

private:
    void solve(femoop::plane::PlaneAnalysis& analysis);
    void refuse(std::vector<femoop::Fault> faults);

    std::shared_ptr<const Solution> solution_;
    std::optional<discretize::MeshedDrawing> mesh_;
    std::optional<femoop::plane::PlaneResults> results_;
    std::vector<femoop::plane::PlaneCase> cases_;
    std::vector<bool> is_loaded_; ///< of each case
    std::vector<femoop::Mechanism> mechanisms_;
    std::vector<femoop::Fault> faults_;
    bool was_cancelled_ = false, is_following_ = false;
};

} // namespace plane
