#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "femoop/solver/ordering.h"

namespace femoop {

/// Which solver factorizes the system matrix.
enum class SolverKind : std::uint8_t {
    Automatic, ///< by size, where measured to be fastest
    Skyline,   ///< ours: L D L' within the profile, for small systems
    Ldlt,      ///< Eigen's SimplicialLDLT: always there
    Cholmod    ///< supernodal CHOLMOD of SuiteSparse, where the library is built with it
};

bool is_available(SolverKind kind);          ///< Cholmod only where the library is built with it
std::vector<SolverKind> available_solvers(); ///< Automatic first
std::string_view name(SolverKind kind);      ///< "automatic", "skyline", "ldlt", "cholmod": as `--solver` takes it
std::optional<SolverKind> solver_named(std::string_view name); ///< of those that are available

/// The solver for a system of this size: the kind itself, unless it is Automatic.
SolverKind resolve(SolverKind kind, std::size_t n_unknowns);

/// The order of elimination that suits the solver best at this size.
Ordering preferred_ordering(SolverKind kind, std::size_t n_unknowns);

} // namespace femoop
