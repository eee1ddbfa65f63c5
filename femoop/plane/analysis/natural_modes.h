#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "femoop/analysis/analysis_options.h"
#include "femoop/model/fault/fault.h"
#include "femoop/plane/analysis/plane_structure.h"

namespace femoop::plane {

/// A shape in which a body vibrates by itself: u(t) = shape sin(omega t).
struct NaturalMode {
    double omega = 0.0;                 ///< rad/s; exactly 0 where the body moves without strain
    std::size_t count = 0;              ///< modes up to this one, with all of its frequency
    std::vector<Eigen::Vector2d> shape; ///< of every node; the largest displacement has length 1
    /// Along x and y, phi' M r / phi' M phi, r moving all by 1; about an axis 0 along x, since nothing moves so.
    Eigen::Vector2d participation = Eigen::Vector2d::Zero();
    Eigen::Vector2d effective_mass = Eigen::Vector2d::Zero(); ///< (phi' M r)^2 / phi' M phi; all modes have total_mass

    double frequency() const; ///< Hz
};

/// The lowest natural modes of a plane body, loads aside: K phi = omega^2 M phi with the consistent mass.
struct NaturalModes {
    std::shared_ptr<const PlaneStructure> structure;
    std::vector<NaturalMode> modes; ///< ascending
    double total_mass = 0.0;        ///< the integral of density over the volume [force time^2 / length]
    std::vector<Fault> warnings;
    AnalysisStatistics statistics;

    const PlaneModel& model() const { return structure->model(); }
    Eigen::Vector2d displacement(const NaturalMode& mode, const Location& place) const;
};

inline constexpr std::size_t usual_n_modes = 10;

/// `wanted` modes; without, the usual number or all that there are. What can move is told by modes of 0 Hz.
///
/// Units    the model's, time in s
/// Source   [Bathe1996, ch. 9-11]; participation and effective mass [CloughPenzien1993, ch. 26]
/// Errors   ModelError  what `check` finds; nothing has mass; fewer modes than wanted; a frequency that is lost in
///                      rounding; a system that the memory cannot hold
///          Cancelled   by options.progress
NaturalModes natural_modes(const PlaneModel& model, std::optional<std::size_t> wanted = {},
                           const AnalysisOptions& options = {});

} // namespace femoop::plane
