#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "femoop/methods/cross/problem.h"

namespace femoop::cross {

/// Where a sway is held, in place of Sway::prop: any node that it moves will do.
struct Prop {
    NodeId node;
    Eigen::Vector2d direction; ///< unit vector along which the node is held
};

/// The axes of a node's support, or x and y: ux, uy.
std::array<Eigen::Vector2d, 2> prop_axes(const Model& model, NodeId node);

/// True where a sway moves the node along the direction.
bool moves(const Problem& problem, const Prop& prop);

/// False where one of the props holds nothing that the others leave free.
bool hold_apart(const Problem& problem, const std::vector<Prop>& props);

/// The same problem with its sways held elsewhere: sway k moves props[k] by 1 and no other prop. Nothing where they
/// leave a sway free, or hold one twice.
/// \pre  as many props as sways, and a problem of the whole structure (Extent::Whole)
std::optional<Problem> propped_at(const Problem& problem, const std::vector<Prop>& props);

/// What the sheets of a propped structure tend to, by the stiffness method: its members' axial strain counts.
struct PropState {
    std::vector<double> moments; ///< at every end
    std::vector<double> forces;  ///< of the props on the structure, along their directions
};

/// The model with its props in place by the force method: F R = -u, where F are the displacements of the props' places
/// under unit forces there, and u those of the model without props.
class ProppedStructure {
public:
    /// \throws ModelError, MechanismError
    ProppedStructure(const Model& model, const Problem& problem);

    PropState loaded() const;
    /// The sway k of the problem alone: its prop moved by so much, the others in place.
    PropState moved(std::size_t k, double by) const;

private:
    PropState with_forces(const Eigen::VectorXd& forces) const;

    PropState free_;                        ///< of the model without props
    std::vector<std::vector<double>> unit_; ///< end moments of a unit force at each prop
    Eigen::MatrixXd flexibility_;           ///< of the props' places
    Eigen::VectorXd gone_;                  ///< how far they move without props
};

} // namespace femoop::cross
