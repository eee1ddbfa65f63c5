#pragma once

#include <array>
#include <string_view>

#include "femoop/model/dof.h"

/// The words that the model file has for enumerators, in the enumerators' order.
namespace femoop::names {

using namespace std::string_view_literals;

inline constexpr std::array analyses{"truss2d"sv, "frame2d"sv, "grillage"sv, "truss3d"sv, "frame3d"sv};
inline constexpr std::array lengths{"m"sv, "mm"sv, "cm"sv, "km"sv, "in"sv, "ft"sv};
inline constexpr std::array forces{"N"sv, "kN"sv, "MN"sv, "lbf"sv, "kip"sv, "tf"sv, "kgf"sv};
inline constexpr std::array masses{"consistent"sv, "lumped"sv};
inline constexpr std::array shapes{"rectangle"sv, "circle"sv, "tube"sv, "box"sv, "i"sv, "t"sv, "l"sv, "c"sv};
inline constexpr std::array supports{"fixed"sv, "pin"sv, "roller"sv}; ///< SupportKind without Custom, which is first
inline constexpr std::array theories{"euler-bernoulli"sv, "timoshenko"sv};
inline constexpr std::array member_loads{"distributed"sv, "point"sv, "ends"sv, "temperature"sv, "misfit"sv};
inline constexpr std::array axes{"global"sv, "local"sv};
inline constexpr std::array expected_analyses{"linear"sv, "p_delta"sv, "buckling"sv, "modal"sv, "plastic"sv};
inline constexpr std::array quantities{"displacement"sv, "reaction"sv,  "section_force"sv,  "extreme"sv,
                                       "load_factor"sv,  "frequency"sv, "collapse_factor"sv};
inline constexpr std::array sides{"-"sv, "+"sv};
inline constexpr std::array extremes{"max"sv, "min"sv};
inline constexpr std::array uniform_extents{"adverse"sv, "whole spans"sv, "everywhere"sv, "outside"sv,
                                            "where it adds"sv}; ///< the last is another word for the first
inline constexpr std::array extra_blocks{"cross"sv, "influence"sv, "train"sv};

inline constexpr std::array<std::string_view, n_dofs> displacements{"ux", "uy", "uz", "rx", "ry", "rz"};
inline constexpr std::array<std::string_view, n_dofs> nodal_forces{"fx", "fy", "fz", "mx", "my", "mz"};
inline constexpr std::array<std::string_view, n_dofs> line_loads{"qx", "qy", "qz", "mx", "my", "mz"};

} // namespace femoop::names
