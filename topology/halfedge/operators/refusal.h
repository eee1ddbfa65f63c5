#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "topology/halfedge/ids.h"

namespace topology {

/// Why an operator is refused. The sentence of each stands in refusal.cpp; {0} {1} {2} are the entities it names.
enum class RefusalKind : std::uint8_t {
    NoSuchEntity,       ///< {0} is dead, or never was
    DifferentVertices,  ///< MEV: {0} and {1} start at {2} and elsewhere
    LoneVertex,         ///< an edge is needed, {0} is a lone vertex
    ClosedEdge,         ///< KEV: both ends of {0} are {1}
    NotBetweenTwoEdges, ///< JEKV: other than two edges meet at {0}
    DifferentLoops,     ///< MEF, KEMR: {0} lies in {1}, the other in {2}
    OneFace,            ///< KEF: both sides of {0} lie in {1}
    OneLoop,            ///< MEKR: {0} and {1} lie in one loop
    DifferentFaces,     ///< MEKR: {0} lies in {1}, the other in {2}
    SameFace,           ///< KFMRH, RINGMV: {0} twice
    HasRings,           ///< KFMRH: {0} has rings
    OuterLoop,          ///< MFKRH, RINGMV, KVR: {0} is the outer loop of {1}
    NotLone,            ///< KVR: {0} is not a lone vertex
    NotSkeletal,        ///< KVFS: {0} is more than a lone vertex
    NotConnected,       ///< RINGMV: nothing but the ring {0} connects {1} with {2}
    SingleClosedEdge,   ///< sweep: the loop {0} is one closed edge at {1}
    NotFaceToFace,      ///< glue: {0} and {1}
    NoShellAndHole,     ///< MSG, KSG: {0} a ring, {1} and {2} faces
    OnPlane,            ///< split: {0} a vertex
};

inline constexpr int n_refusal_kinds = 19;

/// The reason and the entities that it speaks of.
struct Refusal {
    RefusalKind kind = RefusalKind::NoSuchEntity;
    std::array<Entity, 3> entities{};

    friend bool operator==(const Refusal&, const Refusal&) = default;
};

using EntityName = std::function<std::string(Entity)>;
std::string table_name(Entity entity); ///< "v7", as the tables number it

std::string_view pattern(RefusalKind kind); ///< English, with places {0} {1} {2}
/// The pattern with the names of the entities in its places {0} {1} {2}.
std::string sentence_of(std::string_view pattern, std::span<const Entity> entities, const EntityName& name);
std::string sentence(const Refusal& refusal, const EntityName& name = table_name);

/// Thrown by an operator whose `why_not_` gives a reason. The solid is as it was.
class EulerError : public std::runtime_error {
public:
    explicit EulerError(const Refusal& refusal) : std::runtime_error(sentence(refusal)), refusal_(refusal) {}
    const Refusal& refusal() const { return refusal_; }

private:
    Refusal refusal_;
};

} // namespace topology
