#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "femoop/discretisation/case_loads.h"
#include "femoop/methods/cross/problem.h"

namespace femoop::cross {

/// One load case or combination in numbers, joints locked.
struct CaseForces {
    std::vector<Eigen::Vector2d> node_force;
    std::vector<double> node_moment;
    std::vector<Eigen::Vector2d> settlement; ///< of every node, in its support's axes
    std::vector<double> turn;                ///< imposed on the rotation or on its spring's ground [rad]
};

/// A member's action with rigid or released ends, and its imposed elongation.
struct LoadedMember {
    MemberAction action;
    double elongation = 0.0;
    bool can_overhang = false; ///< statics alone finds its forces once its tip is free
    std::array<Eigen::Vector2d, 2> bar_force{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()}; ///< holds a bar's loads
};

/// Reads the members of a structure in a load case or combination, through the analysis's own elements.
std::vector<LoadedMember> loaded_members(const Discretisation& structure, const std::vector<CaseLoads>& loads,
                                         const CaseTerms& terms);

CaseForces case_forces(const Discretisation& structure, const std::vector<CaseLoads>& loads, const CaseTerms& terms);

} // namespace femoop::cross
