#pragma once

#include <optional>

#include "apps/frame/document/document.h"
#include "apps/frame/document/part.h"

namespace frame {

/// Commands that put loads on a structure. Values are in the model's units and axes, signs those of the model file.

/// The place of this load case, or of the first; where the model has none it gets one, named "1".
LoadCasePlace load_case_for(Document& document, femoop::CaseId wanted);

/// A force or moment on a node, added to what acts there in this case. \returns the load
Part add_node_load(Document& document, LoadCasePlace load_case, femoop::NodeId node, const femoop::Component& load);
Part add_member_load(Document& document, LoadCasePlace load_case, femoop::MemberId member,
                     const decltype(femoop::MemberLoad::load)& load);

/// A settlement of the node's support, added to what is imposed on it in this case. \returns the settlement
Part add_settlement(Document& document, LoadCasePlace load_case, femoop::NodeId node,
                    const femoop::Component& displacement);

/// Multiplies the load's values along or about a degree of freedom, and rounds them to about three digits of what they
/// were. Temperatures, misfits and settlements stay.
void scale_load(Document& document, const Part& load, femoop::Dof dof, double factor);

/// Where a point load acts, from the first end of its member's line; nothing of other loads. [length]
std::optional<double> place_of_load(const femoop::Model& model, const Part& load);
/// Puts it elsewhere on its member; a place in percent stays one. \pre it is a point load, x lies on the member's line
void place_load(Document& document, const Part& load, double x);

} // namespace frame
