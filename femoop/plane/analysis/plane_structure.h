#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "femoop/discretisation/case_loads.h"
#include "femoop/discretisation/discretisation.h"
#include "femoop/element/continuum/continuum_element.h"
#include "femoop/plane/mesh/locator.h"
#include "femoop/plane/mesh/node_supports.h"
#include "femoop/plane/model/plane_model.h"

namespace femoop::plane {

/// A plane model as numbers: its elements and supports, as the assembler and the solver of all structures take them.
/// Results hold it, so that they outlive the model.
class PlaneStructure {
public:
    explicit PlaneStructure(PlaneModel model); ///< \pre `check(model)` finds no error
    PlaneStructure(const PlaneStructure&) = delete;
    PlaneStructure& operator=(const PlaneStructure&) = delete;

    const PlaneModel& model() const { return model_; }
    const std::vector<Eigen::Vector2d>& positions() const { return positions_; }
    const CurveTable& curves() const { return *curves_; }
    const NodeSupports& supports() const { return *supports_; }
    const std::shared_ptr<const Discretisation>& discretisation() const { return discretisation_; }
    const EdgeTable& edges() const { return *edges_; }
    const Locator& locator() const; ///< made when it is first asked for
    const ContinuumElement& element(ElementId id) const { return (*elements_)[id.index]; }
    const ConstitutiveModel& material(RegionId region) const { return *materials_[region.index]; }

    /// Indices of the elements that have a node.
    std::span<const std::uint32_t> elements_of(NodeId node) const
    {
        return std::span(elements_of_)
            .subspan(elements_start_[node.index], elements_start_[node.index + 1] - elements_start_[node.index]);
    }
    /// The node in every element of the region that has it. \pre there is one
    std::vector<Location> locations(NodeId node, RegionId region) const;

    std::vector<CaseLoads> loads() const; ///< of every load case

private:
    friend class PlaneLoads;
    /// An edge of a sprung curve, or a sprung point, with its element among the foundations.
    struct SprungEdge {
        CurveId curve;
        std::size_t edge = 0; ///< of the curve
    };

    void list_elements_of_nodes();
    void add_materials();
    void add_elements();
    std::vector<const ContinuumFormulation*> formulations_of_elements();
    void add_supports(Discretisation& structure) const;
    void add_foundations(Discretisation& structure);
    void add_ties(Discretisation& structure) const;
    std::shared_ptr<const Element> edge_foundation(CurveId curve, std::size_t edge) const;

    PlaneModel model_;
    std::vector<Eigen::Vector2d> positions_;
    std::optional<const EdgeTable> edges_;
    std::optional<const CurveTable> curves_;
    std::optional<const NodeSupports> supports_;
    std::vector<std::unique_ptr<const ConstitutiveModel>> materials_;       ///< of each region
    std::vector<std::unique_ptr<const ContinuumFormulation>> formulations_; ///< of regions and shapes
    std::shared_ptr<const ContinuumBlock> elements_;
    std::vector<std::uint32_t> elements_start_, elements_of_; ///< of every node
    std::vector<SprungEdge> sprung_edges_;                    ///< the first foundations
    std::vector<NodeId> sprung_points_;                       ///< those behind them
    std::shared_ptr<const Discretisation> discretisation_;
    mutable std::once_flag is_located_;
    mutable std::unique_ptr<const Locator> locator_;
};

/// What springs of these directions make of a displacement: sum of k d d'.
Eigen::Matrix2d spring_matrix(const std::vector<HeldDirection>& held);

} // namespace femoop::plane
