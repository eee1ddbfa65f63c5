#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace femoop {

/// Which solver factorizes the system matrix.
enum class SolverKind : std::uint8_t {
    Automatic,    ///< whichever solves the system fastest
    Skyline,      ///< ours: L D L' within the profile, for small and for slender systems
    Multifrontal, ///< ours: dense fronts up the elimination tree
    Ldlt,         ///< Eigen's SimplicialLDLT: always there
    Cholmod       ///< supernodal CHOLMOD of SuiteSparse, where the library is built with it
};

bool is_available(SolverKind kind);          ///< Cholmod only where the library is built with it
std::vector<SolverKind> available_solvers(); ///< Automatic first
std::string_view name(
    SolverKind kind); ///< "automatic", "skyline", "multifrontal", "ldlt", "cholmod": as `--solver` takes it
std::optional<SolverKind> solver_named(std::string_view name); ///< of those that are available

} // namespace femoop
