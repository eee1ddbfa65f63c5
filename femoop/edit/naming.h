#pragma once

#include <functional>
#include <string>
#include <vector>

#include "femoop/model/model.h"

namespace femoop {

/// A free name in the manner of the others: the next number where all nodes are numbered, else the first free of
/// A ... Z, A1 ... Z1, ...
std::string fresh_node_id(const Model& model);

/// The next number where all members (or nodes) are numbered, else the names of its nodes: "BC", then "BC2", ...
std::string fresh_member_id(const Model& model, NodeId start, NodeId end);

/// The wanted name, or where it is taken the next free one with a number at its end: "steel", "steel2", "s1", "s2".
std::string fresh_name(const std::string& wanted, const std::function<bool(const std::string&)>& is_taken);
std::string fresh_id(const std::vector<Material>& taken, const std::string& wanted);
std::string fresh_id(const std::vector<Section>& taken, const std::string& wanted);
std::string fresh_case_id(const Model& model, const std::string& wanted); ///< of load cases and combinations alike

/// Does the member have the names of its nodes for a name, "BC" from B to C?
bool is_named_after_nodes(const Model& model, const Member& member);

/// Names the nodes and members that `before` has no name of anew, in their order and as if they were drawn one by one:
/// what was made and welded since then (femoop/edit/weld.h) leaves no gap, and members go by the nodes that they have.
void rename(Model& model, const Model& before);

} // namespace femoop
