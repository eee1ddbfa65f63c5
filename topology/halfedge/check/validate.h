#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "topology/halfedge/operators/refusal.h"
#include "topology/halfedge/solid.h"

namespace topology {

/// What must hold of a solid. The sentence of each stands in validate.cpp.
enum class Invariant : std::uint8_t {
    LinkToLiving,   ///< every link names an entity that lives
    NextAndPrev,    ///< prev(next(h)) is h, and next(prev(h)) is h
    ChainInOneLoop, ///< next(h) lies in the loop of h
    EdgeOfHalf,     ///< an edge's halves are two, and each names the edge
    HalfOfEdge,     ///< a half-edge is one of its edge's halves
    LoneAlone,      ///< a half-edge without edge is its own next
    HalvesOpposite, ///< a half-edge ends where its mate starts
    HalfOfVertex,   ///< the half-edge that a vertex names starts there
    OneFan,         ///< every half-edge that starts at a vertex is met by turning about it
    HalfOfLoop,     ///< the half-edge that a loop names lies in it
    OneChain,       ///< every half-edge of a loop is met by walking along it
    OuterOfFace,    ///< a face's outer loop lies in the face
    LoopsOfFace,    ///< the loops that a face chains are those that name it, in one circle
};

inline constexpr int n_invariants = 13;

/// The first invariant that does not hold, and the entities where it fails.
struct Breach {
    Invariant invariant = Invariant::LinkToLiving;
    std::array<Entity, 2> entities{};

    friend bool operator==(const Breach&, const Breach&) = default;
};
std::string_view pattern(Invariant invariant); ///< English, with places {0} {1}
std::string sentence(const Breach& breach, const EntityName& name = table_name);

/// Looks at every link, however broken they are. Where all hold, the shells are closed orientable surfaces, so that the
/// formula of Euler and Poincare holds too. Geometry is not looked at.
std::optional<Breach> why_not_valid(const Solid& solid);

class BrokenInvariant : public std::logic_error {
public:
    explicit BrokenInvariant(const Breach& breach) : std::logic_error(sentence(breach)), breach_(breach) {}
    const Breach& breach() const { return breach_; }

private:
    Breach breach_;
};
/// \throws BrokenInvariant
void validate(const Solid& solid);

} // namespace topology
