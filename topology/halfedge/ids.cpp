#include "topology/halfedge/ids.h"

#include <array>

namespace topology {

std::ostream& operator<<(std::ostream& out, SolidId id) { return out << 's' << id.index + 1; }
std::ostream& operator<<(std::ostream& out, ShellId id) { return out << "sh" << id.index + 1; }
std::ostream& operator<<(std::ostream& out, FaceId id) { return out << 'f' << id.index + 1; }
std::ostream& operator<<(std::ostream& out, LoopId id) { return out << 'l' << id.index + 1; }
std::ostream& operator<<(std::ostream& out, EdgeId id) { return out << 'e' << id.index + 1; }
std::ostream& operator<<(std::ostream& out, HalfEdgeId id) { return out << "he" << id.index + 1; }
std::ostream& operator<<(std::ostream& out, VertexId id) { return out << 'v' << id.index + 1; }

std::ostream& operator<<(std::ostream& out, Entity entity)
{
    static constexpr std::array letters{"f", "l", "e", "he", "v"};
    return out << letters[static_cast<std::size_t>(entity.kind)] << entity.index + 1;
}

} // namespace topology
