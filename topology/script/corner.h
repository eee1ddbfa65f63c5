#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "topology/script/names.h"

namespace topology {

/// A solid under its user's names, where the words of a script mean something.
struct Named {
    const Solid& solid;
    const Names& names;
    std::string_view name; ///< of the solid, for messages
};

VertexId find_vertex(const Named& in, std::string_view word); ///< \throws LineError
FaceId find_face(const Named& in, std::string_view word);     ///< \throws LineError

/// The half-edge that "%7" names; none if the word is no number. \throws LineError if there is no such half-edge
std::optional<HalfEdgeId> find_numbered(const Named& in, std::string_view word);

/// The half-edge in face f that a corner names: "v1" by its start, "v1>v2" by its end too, "v1>v2>v3" by the end of the
/// next, "%7" by its number. \throws LineError if none fits, or several, which it lists
HalfEdgeId find_corner(const Named& in, FaceId f, std::string_view word);

/// The same in any face. \throws LineError
HalfEdgeId find_half_edge(const Named& in, std::string_view word);

/// The half-edge from one vertex to another, in face f where one is given; `to` may be the half-edge's number instead.
/// \throws LineError as find_corner does
HalfEdgeId find_half_edge(const Named& in, std::optional<FaceId> f, std::string_view from, std::string_view to);

/// The other way: the shortest word that these find h by.
std::string corner_word(const Named& in, HalfEdgeId h);
/// The word for `to` of find_half_edge: the vertex where h ends, or h's number if that fits several.
std::string end_word(const Named& in, HalfEdgeId h, std::optional<FaceId> f);

} // namespace topology
