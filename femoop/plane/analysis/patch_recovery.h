#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "femoop/element/continuum/continuum_formulation.h"
#include "femoop/plane/model/plane_model.h"

namespace femoop::plane {

/// The points of an element at which stresses are best: 2 x 2 Gauss points, of a T6 the 3 inner ones, of a T3 its
/// centroid.
std::span<const ShapeAtPoint> recovery_points(ShapeKind kind);

/// Of values at an element's recovery points, how much each counts at a place: bilinear through 2 x 2, linear through 3,
/// constant of 1.
using RecoveryWeights = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 4, 1>;
RecoveryWeights extrapolation(ShapeKind kind, NaturalPoint at);

/// The numbers of all recovery points, element after element.
class SampleNumbers {
public:
    explicit SampleNumbers(const PlaneModel& model);
    std::size_t first(ElementId element) const { return first_[element.index]; }
    std::size_t size() const { return first_.back(); }

private:
    std::vector<std::size_t> first_;
};

/// Rows of numbers, each [values].
using ValueTable = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Values of nodes from those at the elements' recovery points, region by region and never across a border.
///
/// Method  superconvergent patch recovery: around every corner inside a region a polynomial is fitted to the recovery
///         points of the elements there; it gives the values of the corner, of middle nodes and of nodes on the border,
///         where several patches do their mean. A corner of a border that no such patch reaches has one of its own; a
///         middle node that none reaches has the mean of those around the corners of its elements.
/// Source  [ZienkiewiczTaylor2000, ch. 14]
class PatchRecovery {
public:
    explicit PatchRecovery(const PlaneModel& model);

    /// \param samples, places  rows: recovery points, as SampleNumbers has them  \pre at most 8 values in a row
    ValueTable nodal_values(const ValueTable& samples, const ValueTable& places) const;

    const SampleNumbers& samples() const { return samples_; }
    std::size_t n_values() const { return slot_nodes_.size(); }
    /// The row of an element's node, counted in the element, among the nodal values.
    std::size_t slot(ElementId element, std::size_t node) const { return slots_[first_slot_[element.index] + node]; }
    NodeId node_of(std::size_t slot) const { return slot_nodes_[slot]; }
    RegionId region_of(std::size_t slot) const { return slot_regions_[slot]; }

private:
    void number_slots();
    void find_borders();
    void list_elements();

    const PlaneModel& model_;
    SampleNumbers samples_;
    std::vector<std::size_t> first_slot_;
    std::vector<std::uint32_t> slots_;
    std::vector<NodeId> slot_nodes_;
    std::vector<RegionId> slot_regions_;
    std::vector<bool> is_corner_, is_on_border_;              ///< of each slot
    std::vector<std::uint32_t> elements_start_, elements_of_; ///< of each slot
};

} // namespace femoop::plane
