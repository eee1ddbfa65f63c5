#pragma once

#include <optional>
#include <string>

#include "topology/script/corner.h"

namespace topology {

/// The words that a script says the entities of a solid with, each with a blank before it.
class Wording {
public:
    explicit Wording(const Named& in) : in_(in) {}

    std::string face(FaceId f) const { return " " + in_.names.faces.of(f); }
    std::string vertex(VertexId v) const { return " " + in_.names.vertices.of(v); }
    std::string face_of(HalfEdgeId h) const { return face(in_.solid.face(h)); }
    std::string corner(HalfEdgeId h) const { return " " + corner_word(in_, h); }
    std::string corner(LoopId l) const { return corner(in_.solid.half_edge(l)); }
    std::string point(const Point& p) const;
    std::string ends(HalfEdgeId h) const { return ends(h, std::nullopt); }              ///< "V1 V2": its edge
    std::string ends_in_face(HalfEdgeId h) const { return ends(h, in_.solid.face(h)); } ///< in the face of h
    std::string split(HalfEdgeId from, HalfEdgeId to) const;                            ///< "F1 F2 V1 Va Vb"

private:
    std::string ends(HalfEdgeId h, std::optional<FaceId> f) const
    {
        return vertex(in_.solid.start(h)) + " " + end_word(in_, h, f);
    }

    Named in_;
};

} // namespace topology
