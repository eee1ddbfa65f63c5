#include "topology/halfedge/ids.h"

namespace topology {

std::ostream& operator<<(std::ostream& out, SolidId id) { return out << 's' << id.index; }
std::ostream& operator<<(std::ostream& out, ShellId id) { return out << "sh" << id.index; }
std::ostream& operator<<(std::ostream& out, FaceId id) { return out << 'f' << id.index; }
std::ostream& operator<<(std::ostream& out, LoopId id) { return out << 'l' << id.index; }
std::ostream& operator<<(std::ostream& out, EdgeId id) { return out << 'e' << id.index; }
std::ostream& operator<<(std::ostream& out, HalfEdgeId id) { return out << "he" << id.index; }
std::ostream& operator<<(std::ostream& out, VertexId id) { return out << 'v' << id.index; }

} // namespace topology
