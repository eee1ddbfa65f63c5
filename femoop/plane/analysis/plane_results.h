#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "femoop/analysis/analysis_options.h"
#include "femoop/discretisation/solution.h"
#include "femoop/model/fault/fault.h"
#include "femoop/plane/analysis/patch_recovery.h"
#include "femoop/plane/analysis/plane_structure.h"
#include "femoop/plane/analysis/stress_state_values.h"
#include "femoop/plane/mesh/cut.h"
#include "femoop/result/element_field.h"

namespace femoop::plane {

/// The largest and smallest of a component, with their places.
struct PlaneExtreme {
    double value = 0.0;
    Eigen::Vector2d at = Eigen::Vector2d::Zero();
};

/// N, V and M on a cut, for the face whose outward normal is x' (femoop/plane/mesh/cut.h).
///
/// Signs  N tension positive; V positive along -y'; M about the middle of the material that is met, positive where it
///        stretches the side of -y': dM/dx' = V
struct CutForces {
    double N = 0.0, V = 0.0, M = 0.0;
};
struct CutStation {
    double s = 0.0;
    Eigen::Vector2d at;
    double sx = 0.0, sy = 0.0, txy = 0.0; ///< in the axes of the cut
};

/// What one load case or combination does to the body. Stresses are of the superposed state.
class PlaneCase {
public:
    const std::string& name() const { return terms_.name; }

    Eigen::Vector2d displacement(NodeId node) const;
    Eigen::Vector2d displacement(const Location& place) const;
    bool is_supported(NodeId node) const;        ///< has a support, so a reaction
    Eigen::Vector2d reaction(NodeId node) const; ///< what all supports do to the body there, springs too
    Eigen::Vector2d reaction(const std::vector<NodeId>& nodes) const;
    /// Moment of the reactions of nodes about a place, counter-clockwise.
    double reaction_moment(const std::vector<NodeId>& nodes, const Eigen::Vector2d& about) const;
    Equilibrium equilibrium() const; ///< sums by superposition, the largest residual of the load cases

    /// Stress of an element, bilinear through its 2 x 2 Gauss points (T6 linear through its 3, T3 constant).
    PlaneStress element_stress(const Location& place) const;
    /// The mean of the elements of the region that hold the place.
    PlaneStress element_stress(const std::vector<Location>& places, RegionId region) const;
    /// Recovered by superconvergent patches, interpolated by the element's shapes.
    PlaneStress smoothed_stress(const Location& place) const;
    PlaneStress smoothed_stress(ElementId element, const Shape::Values& N) const; ///< where its shape's functions are N
    PlaneStrain smoothed_strain(const Location& place) const;
    PlaneStress smoothed_stress(NodeId node, RegionId region) const;
    PlaneStrain smoothed_strain(NodeId node, RegionId region) const;
    PlaneStress element_stress(NodeId node, RegionId region) const;

    void sample() const;  ///< finds the stresses of all elements now, and not when they are first asked for
    void recover() const; ///< likewise what is smoothed

    /// Calls visit(place, stress) at every integration point of an element.
    void at_integration_points(ElementId element,
                               const std::function<void(const Eigen::Vector2d&, const PlaneStress&)>& visit) const;

    double energy() const; ///< half the integral of stress times mechanical strain
    /// Zienkiewicz and Zhu's: the norm in energy of recovered less element stresses over that of the recovered ones.
    double error_estimate() const;
    /// What each element has of it: the norm in energy of its own recovered less element stresses, over that of the
    /// recovered stresses of the whole body; their squares sum to that of the estimate.
    const std::vector<double>& element_errors() const;

    /// Of the nodes on an element, K u less what replaces the loads on it; in the order of its points.
    std::vector<Eigen::Vector2d> node_forces(ElementId element) const;
    CutForces forces(const Cut& cut) const;
    std::vector<CutStation> stations(const Cut& cut) const;

    const PlaneStructure& structure() const { return *structure_; }

private:
    friend class PlaneResults;
    struct Samples;   ///< stresses and strains at recovery points
    struct Recovered; ///< nodal values, region by region
    PlaneCase(std::shared_ptr<const PlaneStructure> structure, std::shared_ptr<const detail::Solution> solution,
              std::size_t index);

    ElementField field(ElementId element) const;
    const Samples& samples() const;
    void drop_round_off(Samples& samples) const;
    void drop_round_off_of_reactions();
    double largest_motion() const;
    double motion_as_strain(ElementId element) const; ///< as if the element gave way by all of its displacements
    Eigen::Matrix<double, 8, 1> values_of(RegionId region, const StrainVector& total,
                                          const StrainVector& mechanical) const;
    ValueTable sample_places() const;
    const Recovered& recovered() const;
    Eigen::Matrix<double, 8, 1> element_values(const Location& place) const;
    Eigen::Matrix<double, 8, 1> recovered_values(const Location& place) const;
    Eigen::Matrix<double, 8, 1> recovered_values(ElementId element, const Shape::Values& N) const;
    enum class StressMeasure : std::uint8_t { PerArea, PerLength }; ///< a force per area, or that times the thickness
    Eigen::Vector3d stress_on(const Cut& cut, const CutPiece& piece, double s, StressMeasure measure) const;

    std::shared_ptr<const PlaneStructure> structure_;
    std::shared_ptr<const detail::Solution> solution_;
    CaseTerms terms_;
    std::vector<double> displacements_;
    std::vector<NodeVector> reactions_;
    std::map<std::size_t, std::vector<ThermalLoad>> heat_; ///< of elements that are warmed
    mutable std::shared_ptr<const Samples> samples_;       ///< made when they are first asked for
    mutable std::shared_ptr<const Recovered> recovered_;
    mutable std::shared_ptr<const std::vector<double>> element_errors_;
};

/// The solution of a plane model: all its load cases, then its combinations. Holds what it needs.
class PlaneResults {
public:
    PlaneResults(std::shared_ptr<const PlaneStructure> structure, std::shared_ptr<const detail::Solution> solution,
                 AnalysisStatistics statistics);

    const PlaneModel& model() const { return structure_->model(); }
    std::size_t n_cases() const { return solution_->cases.size(); }
    PlaneCase operator[](CaseId id) const;
    const Locator& locator() const { return structure_->locator(); }
    const std::vector<Fault>& warnings() const { return solution_->warnings; }
    const AnalysisStatistics& statistics() const { return statistics_; }

private:
    std::shared_ptr<const PlaneStructure> structure_;
    std::shared_ptr<const detail::Solution> solution_;
    AnalysisStatistics statistics_;
};

} // namespace femoop::plane
