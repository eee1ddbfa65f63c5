#include "topology/script/wording.h"

#include "topology/text/words.h"

namespace topology {

std::string Wording::point(const Point& p) const
{
    return " " + written(p.x) + " " + written(p.y) + " " + written(p.z);
}

std::string Wording::split(HalfEdgeId from, HalfEdgeId to) const
{
    return face_of(from) + face_of(to) + vertex(in_.solid.start(from)) + " " +
           end_word(in_, from, in_.solid.face(from)) + " " + end_word(in_, to, in_.solid.face(to));
}

} // namespace topology
