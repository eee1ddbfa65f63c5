#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace euler {

/// The words of the script language that are steps.
enum class Verb : std::uint8_t {
    Mvfs,
    Kvfs,
    Mev,
    Split,
    Kev,
    Mef,
    Kef,
    Kemr,
    Mekr,
    Kfmrh,
    Mfkrh,
    Mvr,
    Kvr,
    Semv,
    Jekv,
    Ringmv,
    Move,
    Sweep
};
inline constexpr std::size_t n_verbs = 18;

/// What is chosen for an argument, and how: by pointing at an entity of the solid, or by typing.
enum class ArgumentKind : std::uint8_t {
    Solid,    ///< a living one, by its name
    AnySolid, ///< a living one, or a new name
    Face,
    Corner,   ///< a half-edge; meant is the place at its start, in its face
    HalfEdge, ///< its edge, and which way it runs or on which side it lies
    Ring,     ///< any half-edge of it, or the loop itself
    Vertex,
    NewVertex, ///< a name
    NewFace,   ///< a name
    Point,
    Vector
};

/// Pointing at an entity answers; else something is typed.
bool is_pointed_at(ArgumentKind kind);

struct Argument {
    ArgumentKind kind = ArgumentKind::Solid;
    std::string_view prompt; ///< what is asked for, in English; to be translated
};

/// An operator as a palette offers it. Its arguments are those that must be pointed at or typed; what follows from
/// them, such as the face of a corner, is not asked for.
struct OperatorForm {
    Verb verb = Verb::Mvfs;
    std::string_view word;    ///< of the script: "mev"
    std::string_view name;    ///< "MEV"
    std::string_view meaning; ///< "make an edge and a vertex"; to be translated
    std::array<Argument, 5> all_arguments{};
    std::size_t n_arguments = 0;

    std::span<const Argument> arguments() const { return {all_arguments.data(), n_arguments}; }
};

/// In the order of Verb.
std::span<const OperatorForm> operator_forms();
const OperatorForm& form(Verb verb);

} // namespace euler
