#pragma once

#include "femoop/edit/crossing.h"

namespace femoop {

/// How what was moved or made meets the rest.
struct Welding {
    Crossings crossings = Crossings::Cut;
    std::size_t n_copies = 1; ///< new members came as so many equal groups, each a copy of one structure
};

/// Mends what moving and copying leave behind: nodes at one place (nearer than `nearness_of`) become one node, members
/// between the same two nodes one member, a member whose ends became one node goes, a member that passes a node is cut
/// there (femoop/edit/split.h), and members that cross are cut and get a node (femoop/edit/crossing.h). Of two the
/// earlier stays; supports and hinges of either and the loads of both are kept, a settlement of the later only where
/// the earlier has none.
///
/// What was neither moved nor made since `before` is left as it is, and so are two that were moved but met before.
void weld(Model& model, const Model& before, const Welding& welding = {});

/// The same of a model that is new as a whole; members that cross pass each other.
void weld(Model& model);

} // namespace femoop
