#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "femoop/plane/mesh/mesh_geometry.h"
#include "femoop/plane/model/plane_model.h"

namespace femoop::plane {

/// Every curve of a model: the edges that it runs along, and its geometry.
struct CurveTable {
    CurveTable(const PlaneModel& model, const EdgeTable& edges); ///< \pre every curve has its edges

    std::vector<std::vector<CurveEdge>> edges;
    std::vector<CurveGeometry> geometry;
};

/// A direction of a node along which supports may hold it.
struct HeldDirection {
    Eigen::Vector2d direction; ///< unit vector
    Dof dof = Dof::ux;         ///< of the support's own axes
    bool is_blocked = false;   ///< else a spring holds it
    double stiffness = 0.0;    ///< of the spring of a point
};

/// Whether two are one direction, but for its sense: within 1e-6 of the sine of their angle.
bool are_one(const HeldDirection& a, const HeldDirection& b);

/// What supports do to one node, put together: blocked directions add up, and two different ones block both.
class NodeSupport {
public:
    void add(const HeldDirection& held);

    bool is_held() const { return !blocked_.empty() || !sprung_.empty(); }
    DofSet blocked() const; ///< in axes turned by angle()
    double angle() const;   ///< [rad]; of the one direction that is blocked or sprung, so that it is ux or uy
    DofSet sprung() const;  ///< in the same axes: what springs take part in
    const std::vector<HeldDirection>& blocked_directions() const { return blocked_; }
    const std::vector<HeldDirection>& springs() const { return sprung_; }

private:
    struct Axes {
        double angle = 0.0;
        Dof along = Dof::ux; ///< the one direction
    };
    std::optional<Axes> axes(const std::vector<HeldDirection>& held) const;
    std::vector<HeldDirection> blocked_, sprung_;
};

/// A displacement that is imposed on a node in one direction.
struct ImposedMotion {
    NodeId node;
    HeldDirection held;
    double value = 0.0;
};

/// The displacement of a node, global axes, that motions in one or more directions impose; other directions that are
/// blocked stay at rest. Two motions of one direction that differ are a conflict.
struct ImposedDisplacement {
    Eigen::Vector2d value = Eigen::Vector2d::Zero();
    std::optional<std::array<double, 2>> conflict{};
};

/// The supports of all nodes.
class NodeSupports {
public:
    NodeSupports(const PlaneModel& model, const CurveTable& curves);

    const NodeSupport& operator[](NodeId node) const { return of_node_[node.index]; }
    std::size_t size() const { return of_node_.size(); }

    /// The directions in which one support holds a node: the node's own, or that of a curve with the node's place on it.
    std::vector<HeldDirection> held_by(const PlaneSupport& support, const CurveNode* on_curve) const;

    /// Such a node keeps ux = 0 by itself, besides what holds it.
    bool is_on_axis_of_revolution(NodeId node) const;

    /// Everything that a settlement imposes, node by node.
    std::vector<ImposedMotion> motions(const PlaneSettlement& settlement) const;

    /// What motions of one node impose on it.
    ImposedDisplacement displacement(NodeId node, std::vector<ImposedMotion> motions) const;

private:
    /// Supports that hold a node: that of the point first, then those of curves, with the node's place along them.
    struct Holder {
        const PlaneSupport* support;
        const CurveNode* on_curve;
    };
    std::vector<Holder> holders(NodeId node) const;
    std::vector<ImposedMotion> motions_of_point(const PlaneSettlement& settlement) const;

    const PlaneModel& model_;
    const CurveTable& curves_;
    std::vector<NodeSupport> of_node_;
};

} // namespace femoop::plane
