#pragma once

#include "apps/drawing/sketch/scene.h"

namespace drawing {

/// Whether the structure is the subject, or stands behind its deformed shape.
enum class Presence : std::uint8_t { Subject, Behind };

/// Members by kind (beam, bar, rigid), rigid arms, marks of missing strain (EA → ∞), foundations; in space from back
/// to front.
void draw_members(const Scene& scene, Presence presence);
/// Broad lines below what is hovered or selected.
void draw_highlights(const Scene& scene);
ui::Stroke highlight_stroke(const Scene& scene, ui::Role role);
/// Joints, hinges, releases and semi-rigid ends.
void draw_joints(const Scene& scene);
/// A node as a hinge where its members turn freely, else as a dot, moved aside with its part of the structure.
void draw_node_joint(const Scene& scene, femoop::NodeId node, const Eigen::Vector3d& aside);
/// How an end of a member is joined to its node: nothing where it is so rigidly.
void draw_end_joint(const Scene& scene, femoop::MemberId member, std::size_t end, const Eigen::Vector3d& aside);
/// Names of nodes and members, as far as they are to be shown.
void draw_names(const Scene& scene);
/// The members' own axes at their middles.
void draw_local_axes(const Scene& scene);

bool is_bar(const femoop::Model& model, femoop::MemberId member); ///< carries axial force only

} // namespace drawing
