#pragma once

#include <Eigen/Core>
#include <array>
#include <numbers>

#include "femoop/material/stress_state.h"
#include "femoop/model/dof.h"

namespace femoop {

/// What distinguishes the models of continua, as `AnalysisModel` does for members: the degrees of freedom of a node,
/// and how they strain a point.
///
///      e = sum B_i (ux, uy)_i      over nodes i;  B_i is made of N_i and of its derivatives by x and y
///
/// `depth` is what an area of the drawing stands for in space: the thickness, or the whole turn about the axis.
///
/// Signs    e in the order of `components(state)`: tension positive, gxy the whole angle
/// Assumes  small displacements
/// Source   [MarthaParente2002]: the class AnalysisModel; [ZienkiewiczTaylor2000, ch. 4-5]
template <StressState state> struct ContinuumModel;

inline constexpr std::array plane_dofs{Dof::ux, Dof::uy};

template <> struct ContinuumModel<StressState::PlaneStress> {
    static constexpr int n_strains = n_components(StressState::PlaneStress);

    static Eigen::Matrix<double, n_strains, 2> B(double /*N*/, double dx, double dy, double /*r*/)
    {
        Eigen::Matrix<double, n_strains, 2> B;
        B << dx, 0.0, //
            0.0, dy,  //
            dy, dx;
        return B;
    }
    static double depth(double thickness, double /*r*/) { return thickness; }
};

template <> struct ContinuumModel<StressState::PlaneStrain> {
    static constexpr int n_strains = n_components(StressState::PlaneStrain);

    static Eigen::Matrix<double, n_strains, 2> B(double /*N*/, double dx, double dy, double /*r*/)
    {
        Eigen::Matrix<double, n_strains, 2> B;
        B << dx, 0.0, //
            0.0, dy,  //
            0.0, 0.0, //
            dy, dx;
        return B;
    }
    static double depth(double thickness, double /*r*/) { return thickness; }
};

/// x is the radius r; the hoop strain is u / r, and on the axis, where u = 0, its limit du/dr.
template <> struct ContinuumModel<StressState::Axisymmetric> {
    static constexpr int n_strains = n_components(StressState::Axisymmetric);

    static Eigen::Matrix<double, n_strains, 2> B(double N, double dr, double dy, double r)
    {
        Eigen::Matrix<double, n_strains, 2> B;
        B << dr, 0.0,                  //
            0.0, dy,                   //
            r > 0.0 ? N / r : dr, 0.0, //
            dy, dr;
        return B;
    }
    static double depth(double /*thickness*/, double r) { return 2.0 * std::numbers::pi * r; }
};

} // namespace femoop
