#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "apps/frame/document/document.h"
#include "apps/frame/document/part.h"
#include "apps/frame/document/selection.h"
#include "femoop/edit/place.h"
#include "femoop/edit/weld.h"

namespace frame {

/// Commands that change what a structure consists of. Places are in the plane of the model, in its unit of length;
/// those of a model in space have three coordinates.

/// A node where there is none yet; a member that passes there is cut.
void add_node(Document& document, const Eigen::Vector2d& place);
void add_node_in_space(Document& document, const Eigen::Vector3d& place);

/// A member of the last one's material, section and theory, else of the last material and section that there are.
femoop::Member like_last_member(const femoop::Model& model);

/// Members along a straight line, made like the last one of the model. A model without any material or section gets
/// steel and a section to begin with. Crossed members are cut (femoop/edit/draw.h) unless they are to be kept. Nothing
/// where the places are one.
void draw_member(Document& document, const Eigen::Vector2d& start, const Eigen::Vector2d& end,
                 femoop::Crossings crossings = femoop::Crossings::Cut);
void draw_member_in_space(Document& document, const Eigen::Vector3d& start, const Eigen::Vector3d& end,
                          femoop::Crossings crossings = femoop::Crossings::Cut);

/// Takes these parts out, and what cannot be without them; where a node goes at which two equal members go on straight,
/// they become one member. Materials and sections in use stay.
void remove(Document& document, std::span<const Part> parts);

/// The nodes of the parts: themselves, and the ends of members.
std::vector<femoop::NodeId> nodes_of(const femoop::Model& model, std::span<const Part> parts);

/// Moves, turns, mirrors or scales the nodes of the parts; dimension lines between them keep their side. What lands on
/// something is not joined to it yet: see `join`.
void place(Document& document, std::span<const Part> parts, const femoop::Placement& placement);

/// Copies nodes and members with their supports, loads and dimension lines, `times` times, each copy placed on from the
/// one before. \returns the parts of the last copies
std::vector<Part> copy(Document& document, std::span<const Part> parts, const femoop::Placement& placement,
                       int times = 1);

/// Joins what was moved or made since `before` to what it meets, and cuts what it crosses (femoop/edit/weld.h): the end
/// of every gesture that moved something.
void join(Document& document, const femoop::Model& before, const femoop::Welding& welding = {});

/// The same, and the selection goes with what is joined.
void join(Document& document, Selection& selection, const femoop::Model& before, const femoop::Welding& welding = {});

/// Names the nodes and members that were made since `before` as if they were drawn one by one (femoop/edit/naming.h),
/// in dimension lines too: copies that were joined keep no gaps and no names of nodes that are gone.
void rename(Document& document, const femoop::Model& before);

} // namespace frame
