#pragma once

#include <memory>
#include <vector>

#include "femoop/analysis/elimination.h"
#include "femoop/analysis/mechanism.h"
#include "femoop/analysis/member_mechanism.h"
#include "femoop/analysis/unrestrained_rotation.h"
#include "femoop/discretisation/equations.h"
#include "femoop/discretisation/solution.h"

namespace femoop {

/// Free motions of a structure, as mechanisms with words: which nodes move together, and how.
std::vector<Mechanism> mechanisms_of(const Model& model, const std::shared_ptr<const Discretisation>& structure,
                                     const Equations& equations, std::vector<detail::CaseSolution> motions);

Mechanism member_mechanism(const Model& model, const Discretisation& structure, const LooseMember& loose);

/// A restrained rotation that loads drive.
Mechanism rotation_mechanism(const Model& model, const Discretisation& structure, const ArtificialRestraint& rotation);

/// The stiffness at these nodes cannot be counted with.
Fault beyond_range_fault(const Model& model, const std::vector<NodeId>& nodes);

/// A warning that names the nodes that move most in the softest motion, one row of `n` numbers per node.
Fault nearly_singular_fault(const Model& model, double condition, const std::vector<double>& displacements,
                            std::size_t n);

std::vector<Fault> conflict_faults(const Model& model, const std::vector<Elimination::Conflict>& conflicts);

} // namespace femoop
