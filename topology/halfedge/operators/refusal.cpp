#include "topology/halfedge/operators/refusal.h"

#include <sstream>

namespace topology {

std::string table_name(Entity entity)
{
    std::ostringstream out;
    out << entity;
    return out.str();
}

std::string_view pattern(RefusalKind kind)
{
    switch (kind) {
    case RefusalKind::NoSuchEntity: return "there is no {0}; it was killed or never made";
    case RefusalKind::DifferentVertices:
        return "{0} starts at {2} and {1} does not; give two half-edges that start at one vertex";
    case RefusalKind::LoneVertex: return "{0} is a lone vertex without an edge; make one with MEV first";
    case RefusalKind::ClosedEdge: return "both ends of {0} are {1}; kill it with KEF or KEMR";
    case RefusalKind::NotBetweenTwoEdges: return "other than two edges meet at {0}; kill one with KEV";
    case RefusalKind::DifferentLoops:
        return "one half-edge lies in loop {1} and the other in loop {2}; "
               "an operator for two loops is MEKR, for two faces KEF";
    case RefusalKind::OneFace: return "both sides of {0} lie in face {1}; kill it with KEV or KEMR";
    case RefusalKind::OneLoop: return "{0} and {1} lie in one loop; split it with MEF";
    case RefusalKind::DifferentFaces:
        return "{0} lies in face {1} and the other half-edge in face {2}; MEKR needs one face";
    case RefusalKind::SameFace: return "{0} is given twice; two faces are needed";
    case RefusalKind::HasRings: return "{0} has rings; move them to another face with RINGMV first";
    case RefusalKind::OuterLoop: return "{0} is the outer loop of face {1}; a ring is needed";
    case RefusalKind::NotLone: return "{0} is not a lone vertex; take its edges away first";
    case RefusalKind::NotSkeletal: return "{0} is more than a lone vertex; take its edges and rings away first";
    case RefusalKind::NotConnected: return "nothing but the ring {0} connects {1} with {2}; it cannot move there";
    case RefusalKind::SingleClosedEdge:
        return "the loop {0} is one closed edge at {1}, which has no second corner; split it with SEMV first";
    case RefusalKind::NotFaceToFace:
        return "{0} and {1} do not lie face to face: corner upon corner, "
               "one turned against the other, without a common vertex";
    case RefusalKind::NoShellAndHole:
        return "with the ring {0} and the faces {1} and {2} the shells and the handles do not change by one each";
    case RefusalKind::OnPlane:
        return "at {0} faces in the plane meet whose parts lie on both sides of it; move the plane a little";
    }
    return "";
}

std::string sentence_of(std::string_view pattern, std::span<const Entity> entities, const EntityName& name)
{
    std::string filled;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        if (pattern[i] != '{') {
            filled += pattern[i];
            continue;
        }
        filled += name(entities[static_cast<std::size_t>(pattern[i + 1] - '0')]);
        i += 2;
    }
    return filled;
}

std::string sentence(const Refusal& refusal, const EntityName& name)
{
    return sentence_of(pattern(refusal.kind), refusal.entities, name);
}

} // namespace topology
