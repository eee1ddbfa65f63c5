#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "femoop/element/continuum/continuum_formulation.h"
#include "femoop/model/check/entry_checker.h"
#include "femoop/plane/check/plane_check.h"
#include "femoop/plane/mesh/locator.h"
#include "femoop/plane/mesh/node_supports.h"

namespace femoop::plane {

/// The regions whose elements meet each point, in the order of their elements.
class RegionsOfPoints {
public:
    explicit RegionsOfPoints(const PlaneModel& model);
    bool is_empty(NodeId point) const { return first_[point.index] == none; }
    std::vector<RegionId> of(NodeId point) const;

private:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> first_;
    std::map<NodeId, std::vector<RegionId>> others_; ///< of points on borders
};

/// Goes through a plane model part by part and writes down what is wrong with it.
class PlaneChecker : private EntryChecker {
public:
    PlaneChecker(const PlaneModel& model, const Unreadable& unreadable);
    std::vector<Fault> run();

private:
    // plane_checker.cpp
    bool has_errors() const;
    std::string analysis() const { return std::string(name(model_.analysis)); }
    /// Of a mesh that could be read: nothing takes what is put on the point.
    bool has_no_elements(NodeId point) const
    {
        return !model_.is_drawn && !unreadable_.is_incomplete && regions_of_point_->is_empty(point);
    }
    bool is_readable(MaterialId id) const
    {
        return id.index < model_.materials.size() && !flag(unreadable_.materials, id.index);
    }
    template <class First, class Second> void together(const First& first, const Second& second) const;
    void check_ids();
    void check_materials();
    void check_points();
    void check_support(const PlaneSupport& support, bool is_on_curve, const Entry& place);
    void check_regions();
    void require_formulation(ShapeKind kind, RegionId region);
    void check_mesh_options(const MeshOptions& mesh, const Entry& place);
    void check_elements();
    std::vector<std::uint8_t> flawless_elements(); ///< 1 of those
    bool is_flawless(const PlaneElement& element) const;
    void check_element(const PlaneElement& element, const Entry& place);
    void check_curves();
    void check_tied(const PlaneCurve& curve, const Entry& place);
    void check_ties(); ///< \pre the mesh is sound

    // drawing_check.cpp
    void check_drawn_curves();
    void check_shape(const DrawnShape& shape, const Entry& place);
    void check_places(const DrawnShape& shape, const Entry& place);
    void check_place(const DrawnPlace& drawn, const Entry& place);
    void check_drawn_regions();
    void check_face_asked(const PlaneExpected& check, const Entry& place);

    // plane_checker.cpp, of the whole
    void check_use();
    void warn_of_locking();

    // plane_load_check.cpp
    void check_load_cases();
    void check_self_weight(const PlaneLoadCase& load_case, const Entry& place);
    void check_load(const NodeLoad& load, const Entry& place);
    void check_load(const CurveLoad& load, const Entry& place);
    void check_load(const RegionLoad& load, const Entry& place);
    void check_load(const PlaneSettlement& settlement, const Entry& place);
    void check_field(const std::optional<Field>& field, std::string_view key, bool is_on_curve, const Entry& place);
    void check_sides(CurveLoadKind kind, CurveId curve, const Entry& place);
    /// Calls use(region, its material) for those that a load is on.
    template <class Use> void for_regions(const std::vector<RegionId>& regions, Use use) const;
    void require_density(const std::vector<RegionId>& regions, const Entry& place);
    void require_expansion(const std::vector<RegionId>& regions, const Entry& place);
    void check_settlements(); ///< that agree at every node. \pre the mesh is sound
    using MotionsOfNodes = std::map<NodeId, std::vector<ImposedMotion>>;
    /// Two displacements of one direction of a node, in one load case.
    struct Conflict {
        NodeId node;
        double a = 0.0, b = 0.0;
    };
    std::optional<Conflict> conflict_of(const MotionsOfNodes& of_node) const;

    // plane_expected_check.cpp
    void check_expected();
    void check_expected(const PlaneExpected& check, const Entry& place);
    std::vector<std::string_view> missing_keys(const PlaneExpected& check) const;
    void check_asked(const PlaneExpected& check, const Entry& place);
    void check_place(const PlaneExpected& check, const Entry& place); ///< \pre the mesh is sound
    void check_cut(const PlaneExpected& check, const Entry& place);   ///< likewise
    void check_reaction(const PlaneExpected& check, const Entry& place);
    void check_extreme(const PlaneExpected& check, const Entry& place);
    const Locator& locator();
    std::vector<RegionId> regions_at(const PlaneExpected& check);

    const PlaneModel& model_;
    const Unreadable& unreadable_;
    std::optional<const EdgeTable> edges_;
    GeometryChecks geometry_checks_;
    std::optional<const RegionsOfPoints> regions_of_point_;
    std::optional<CurveTable> curves_; ///< once the mesh is known to be sound
    std::optional<NodeSupports> supports_;
    std::optional<Locator> locator_; ///< made when it is first asked for
};

} // namespace femoop::plane
