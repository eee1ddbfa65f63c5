#include "femoop/solver/solver_kind.h"

#include <array>

#include "femoop/solver/cholmod_solver.h"

namespace femoop {

namespace {

struct NamedSolver {
    SolverKind kind;
    std::string_view name;
};
constexpr std::array<NamedSolver, 5> named{{{SolverKind::Automatic, "automatic"},
                                            {SolverKind::Multifrontal, "multifrontal"},
                                            {SolverKind::Skyline, "skyline"},
                                            {SolverKind::Ldlt, "ldlt"},
                                            {SolverKind::Cholmod, "cholmod"}}};

} // namespace

bool is_available(SolverKind kind) { return kind != SolverKind::Cholmod || has_cholmod(); }

std::vector<SolverKind> available_solvers()
{
    std::vector<SolverKind> kinds;
    for (const NamedSolver& each : named)
        if (is_available(each.kind)) kinds.push_back(each.kind);
    return kinds;
}

std::string_view name(SolverKind kind)
{
    for (const NamedSolver& each : named)
        if (each.kind == kind) return each.name;
    return {};
}

std::optional<SolverKind> solver_named(std::string_view name)
{
    for (const NamedSolver& each : named)
        if (each.name == name && is_available(each.kind)) return each.kind;
    return std::nullopt;
}

} // namespace femoop
