#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "apps/frame/document/part.h"
#include "femoop/model/model.h"

namespace cross {

/// What a hand changes of a structure. What the file says of expected results goes, since it speaks of another one.

/// A node at another place, along the beam where all nodes lie on one level; nothing where a member would have no
/// length, or lie on its neighbour.
std::optional<femoop::Model> with_node_at(const femoop::Model& model, femoop::NodeId node, Eigen::Vector2d place);

/// A load's values along a degree of freedom so many times as large.
femoop::Model with_load_scaled(const femoop::Model& model, const frame::Part& load, femoop::Dof dof, double factor);

/// The outermost node of a side, if one member alone meets it.
enum class Side : std::uint8_t { Left, Right };
std::optional<femoop::NodeId> end_node(const femoop::Model& model, Side side);

/// All nodes on one level: a beam.
bool is_level(const femoop::Model& model);
/// Without results that are expected of the structure as it was, their source in the notes, and, of the beam that the
/// app begins with, its title and notes.
femoop::Model unverified(femoop::Model model);
bool is_sound(const femoop::Model& model); ///< `check` finds no error
std::vector<femoop::MemberId> members_at(const femoop::Model& model, femoop::NodeId node);
femoop::NodeId far_node(const femoop::Model& model, femoop::MemberId member, femoop::NodeId node);
Eigen::Vector2d place_of(const femoop::Model& model, femoop::NodeId node);

} // namespace cross
