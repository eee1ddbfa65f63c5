#include "femoop/model/dof.h"

namespace femoop {

namespace {

using Names = std::array<std::string_view, n_dofs>;
constexpr Names displacement_names{"ux", "uy", "uz", "rx", "ry", "rz"};
constexpr Names force_names{"fx", "fy", "fz", "mx", "my", "mz"};

std::optional<Dof> find(const Names& names, std::string_view name)
{
    for (const Dof dof : all_dofs)
        if (names[index(dof)] == name) return dof;
    return std::nullopt;
}

} // namespace

std::string_view name(Dof dof) { return displacement_names[index(dof)]; }
std::string_view force_name(Dof dof) { return force_names[index(dof)]; }
std::optional<Dof> find_dof(std::string_view name) { return find(displacement_names, name); }
std::optional<Dof> find_force_dof(std::string_view name) { return find(force_names, name); }

std::string names_of(DofSet dofs)
{
    std::string text;
    for (const Dof dof : all_dofs)
        if (dofs.contains(dof)) text += (text.empty() ? "" : " ") + std::string(name(dof));
    return text;
}

std::string_view name(AnalysisKind kind)
{
    static constexpr std::array<std::string_view, 5> names{"truss2d", "frame2d", "grillage", "truss3d", "frame3d"};
    return names[static_cast<std::size_t>(kind)];
}

} // namespace femoop
