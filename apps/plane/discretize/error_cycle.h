#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "apps/plane/discretize/drawing.h"
#include "femoop/model/ids.h"
#include "femoop/plane/analysis/plane_results.h"
#include "topology/meshing/size_field.h"

namespace discretize {

/// A mesh and the error that its results have.
struct MeshError {
    std::size_t n_elements = 0, n_unknowns = 0;
    double error = 0.0; ///< Zienkiewicz and Zhu's estimate, 0.05 is 5 %
};

/// A small element of the last mesh of a cycle.
struct SmallElement {
    Eigen::Vector2d at = Eigen::Vector2d::Zero();
    double size = 0.0;
};

/// Why a cycle of refinement goes no further.
enum class CycleEnd : std::uint8_t {
    Exact,    ///< the error is rounding
    TooLarge, ///< the next mesh would have too many unknowns
    NoGain    ///< the last mesh has hardly less error than the one before, with more unknowns
};

/// The sizes of the next mesh of a cycle, or why there is none.
struct NextMesh {
    std::shared_ptr<const topology::SizeField> sizes; ///< null: none
    std::optional<CycleEnd> end{};
    double n_unknowns = 0.0; ///< that it has, about
};

/// Refinement by the error: a mesh is solved, the sizes that halve its estimated error with as few elements as possible
/// are found (femoop/plane/result/refined_sizes.h), the drawing is meshed by them, and so on. A plain value: somebody
/// else meshes and solves, and adds what came of it.
///
///     log error |  o          o  refined by the error: the slope is -p/2 even beside singular corners
///               |    \  x     x  all sizes of the first mesh halved again and again
///               |      o    x
///               +----------------- log unknowns
///
/// Each mesh is bounded in its unknowns before it is made, and a cycle that gains nothing ends: it cannot run for ever.
class ErrorCycle {
public:
    static constexpr std::size_t most_cycles = 8;
    static constexpr std::size_t usual_unknowns = 200'000; ///< at most, of one mesh

    explicit ErrorCycle(femoop::CaseId load_case = {}, std::size_t most_unknowns = usual_unknowns)
        : load_case_(load_case), most_unknowns_(most_unknowns)
    {}

    /// The mesh that its sizes gave, the drawing's own first. \pre the result is of the cycle's case
    void add(const femoop::plane::PlaneResults& results, const femoop::plane::PlaneCase& result);
    NextMesh next() const; ///< \pre a mesh was added
    /// The next mesh is made by these sizes.
    void take(std::shared_ptr<const topology::SizeField> sizes) { sizes_ = std::move(sizes); }
    /// Meshes with all sizes of the first halved, as far as they have about as many unknowns as the last mesh.
    /// \param is_cancelled  asked now and then; then it compares no further
    void compare(const Drawing& drawing, const std::function<bool()>& is_cancelled = {});

    femoop::CaseId load_case() const { return load_case_; }
    std::size_t most_unknowns() const { return most_unknowns_; }
    const std::vector<MeshError>& meshes() const { return meshes_; }   ///< that were refined by the error
    const std::vector<MeshError>& uniform() const { return uniform_; } ///< the same first one, then evenly refined
    /// Of the last mesh; null: the drawing's own.
    const std::shared_ptr<const topology::SizeField>& sizes() const { return sizes_; }

    std::size_t memory() const; ///< [bytes], about

    int degree() const { return degree_; }               ///< of the elements; the least where they differ
    double smooth_rate() const { return 0.5 * degree_; } ///< the error of smooth stresses goes with N^-rate
    /// Where the evenly refined meshes fall behind what smooth stresses would have, and the cycle made elements by far
    /// smaller than elsewhere: the smallest of them, as at a corner where stresses grow without bound.
    std::optional<SmallElement> singular_place() const;

private:
    femoop::CaseId load_case_;
    std::size_t most_unknowns_;
    int degree_ = 0;
    std::vector<MeshError> meshes_, uniform_;
    std::shared_ptr<const topology::SizeField> sizes_;
    std::shared_ptr<const topology::SizeField> first_;  ///< what the first mesh has
    std::shared_ptr<const topology::SizeField> wanted_; ///< by the errors of the last one
    double growth_ = 1.0;                               ///< of the number of elements that these make, about
    SmallElement smallest_;                             ///< of the last mesh
    double shrinkage_ = 1.0;                            ///< its size over that of the first mesh there
};

/// The rate at which the error falls from one mesh to the next, -d log error / d log unknowns: of the last two, nothing
/// where there are none or they are too alike in their unknowns.
std::optional<double> rate(const std::vector<MeshError>& meshes);

/// The first region that asks to be mapped: its mesh follows its sides, not sizes inside it.
std::optional<femoop::plane::RegionId> mapped_region(const femoop::plane::PlaneModel& model);

} // namespace discretize
