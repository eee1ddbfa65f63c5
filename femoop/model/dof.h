#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace femoop {

/// Degrees of freedom of a node, and the components of a load that does work on each: fx fy fz mx my mz.
enum class Dof : std::uint8_t { ux, uy, uz, rx, ry, rz };

inline constexpr std::size_t n_dofs = 6;
inline constexpr std::array<Dof, n_dofs> all_dofs{Dof::ux, Dof::uy, Dof::uz, Dof::rx, Dof::ry, Dof::rz};

constexpr std::size_t index(Dof dof) { return static_cast<std::size_t>(dof); }
constexpr bool is_rotation(Dof dof) { return dof >= Dof::rx; }
std::string_view name(Dof dof);                           ///< "ux" ... "rz"
std::string_view force_name(Dof dof);                     ///< "fx" ... "mz"
std::optional<Dof> find_dof(std::string_view name);       ///< of "ux" ... "rz"
std::optional<Dof> find_force_dof(std::string_view name); ///< of "fx" ... "mz"

/// A set of degrees of freedom.
class DofSet {
public:
    constexpr DofSet() = default;
    constexpr DofSet(std::initializer_list<Dof> dofs)
    {
        for (const Dof dof : dofs) insert(dof);
    }
    constexpr void insert(Dof dof) { bits_ = static_cast<std::uint8_t>(bits_ | (1U << index(dof))); }
    constexpr void erase(Dof dof) { bits_ = static_cast<std::uint8_t>(bits_ & ~(1U << index(dof))); }
    constexpr bool contains(Dof dof) const { return ((bits_ >> index(dof)) & 1U) != 0; }
    constexpr bool is_empty() const { return bits_ == 0; }
    constexpr int size() const
    {
        int n = 0;
        for (const Dof dof : all_dofs) n += contains(dof) ? 1 : 0;
        return n;
    }
    friend constexpr bool operator==(DofSet, DofSet) = default;

private:
    std::uint8_t bits_ = 0;
};

std::string names_of(DofSet dofs); ///< "ux uy rz"

/// One number per degree of freedom ux uy uz rx ry rz (or force fx fy fz mx my mz); those that the model lacks are 0.
using NodeVector = std::array<double, n_dofs>;

/// The five models of member structures: which displacements a node has and which forces a member carries.
///
///   Truss2d   ux uy            N
///   Frame2d   ux uy rz         N V M            (V = Vy, M = Mz)
///   Grillage  uz rx ry         V M T            members in the xy plane, loads along z
///   Truss3d   ux uy uz         N
///   Frame3d   ux uy uz rx ry rz    N Vy Vz T My Mz
enum class AnalysisKind : std::uint8_t { Truss2d, Frame2d, Grillage, Truss3d, Frame3d };

std::string_view name(AnalysisKind kind); ///< "truss2d" ... "frame3d"
constexpr bool is_plane(AnalysisKind kind) { return kind == AnalysisKind::Truss2d || kind == AnalysisKind::Frame2d; }
constexpr bool is_3d(AnalysisKind kind) { return kind == AnalysisKind::Truss3d || kind == AnalysisKind::Frame3d; }
constexpr bool is_truss(AnalysisKind kind) { return kind == AnalysisKind::Truss2d || kind == AnalysisKind::Truss3d; }
constexpr std::size_t n_coordinates(AnalysisKind kind) { return is_3d(kind) ? 3 : 2; }

/// The degrees of freedom that a node has in this model.
constexpr DofSet dofs(AnalysisKind kind)
{
    switch (kind) {
    case AnalysisKind::Truss2d: return {Dof::ux, Dof::uy};
    case AnalysisKind::Frame2d: return {Dof::ux, Dof::uy, Dof::rz};
    case AnalysisKind::Grillage: return {Dof::uz, Dof::rx, Dof::ry};
    case AnalysisKind::Truss3d: return {Dof::ux, Dof::uy, Dof::uz};
    case AnalysisKind::Frame3d: break;
    }
    return {Dof::ux, Dof::uy, Dof::uz, Dof::rx, Dof::ry, Dof::rz};
}

/// The degrees of freedom of a member's end in its own axes: what can be released there, and what its span loads can
/// work on. Grillage: the member's y' is up, so it bends about z' and twists about x'.
constexpr DofSet member_dofs(AnalysisKind kind)
{
    return kind == AnalysisKind::Grillage ? DofSet{Dof::uy, Dof::rx, Dof::rz} : dofs(kind);
}

} // namespace femoop
