#pragma once

#include <array>
#include <string_view>

/// The words that the file of a plane model has for enumerators, in the enumerators' order.
namespace femoop::plane::names {

using namespace std::string_view_literals;

inline constexpr std::array analyses{"plane_stress"sv, "plane_strain"sv, "axisymmetric"sv}; ///< StressState
inline constexpr std::array supports{"fixed"sv, "pin"sv, "roller"sv, "symmetry"sv}; ///< without Custom, which is first
inline constexpr std::array shapes{"T3"sv, "T6"sv, "Q4"sv, "Q8"sv,
                                   "Q9"sv}; ///< ShapeKind without lines, which are first
inline constexpr std::array formulations{"standard"sv, "reduced"sv, "b_bar"sv, "incompatible"sv};
inline constexpr std::array methods{"auto"sv,     "mapped"sv, "trilateral"sv, "sweep"sv,
                                    "delaunay"sv, "front"sv,  "quadtree"sv,   "quads"sv};
inline constexpr std::array diagonals{"right"sv, "left"sv, "cross"sv, "shortest"sv};
inline constexpr std::array curves{"edges"sv};
inline constexpr std::array drawn_curves{"line"sv, "arc"sv, "circle"sv, "ellipse"sv, "bezier"sv, "spline"sv};
inline constexpr std::array turns{"ccw"sv, "cw"sv};
inline constexpr std::array curve_loads{"traction"sv, "line"sv, "pressure"sv};
inline constexpr std::array region_loads{"body"sv, "temperature"sv, "rotation"sv};
inline constexpr std::array along{"x"sv, "y"sv, "r"sv, "s"sv};
inline constexpr std::array readings{"smoothed"sv, "element"sv, "gauss"sv};
inline constexpr std::array counted{"vertices"sv, "edges"sv, "regions"sv, "components"sv, "dangling"sv, "holes"sv};

} // namespace femoop::plane::names
