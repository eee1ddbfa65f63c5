#include "topology/script/corner.h"

#include <charconv>
#include <vector>

#include "topology/script/script_fault.h"

namespace topology {

namespace {

std::vector<VertexId> path(const Named& in, std::string_view word)
{
    std::vector<VertexId> vertices;
    for (std::string_view rest = word;;) {
        const auto mark = rest.find('>');
        const std::string_view name = rest.substr(0, mark);
        if (name.empty()) throw error(ScriptFault::BadCorner, {std::string(word)});
        vertices.push_back(find_vertex(in, name));
        if (mark == std::string_view::npos) return vertices;
        rest.remove_prefix(mark + 1);
    }
}

/// h starts at the path's first vertex; does it go on along the path?
bool follows(const Solid& solid, HalfEdgeId h, const std::vector<VertexId>& vertices)
{
    if (vertices.size() > 1 && !solid.edge(h)) return false;
    for (std::size_t i = 1; i < vertices.size(); ++i) {
        h = solid.next(h);
        if (solid.start(h) != vertices[i]) return false;
    }
    return true;
}

/// All that start at the path's first vertex, in the order of its fan, and fit; no more than `most` of them.
std::vector<HalfEdgeId> in_fan(const Solid& solid, std::optional<FaceId> f, const std::vector<VertexId>& vertices,
                               std::size_t most)
{
    std::vector<HalfEdgeId> found;
    for (const HalfEdgeId h : solid.fan(vertices.front())) {
        if (found.size() == most) break;
        if ((!f || solid.face(h) == *f) && follows(solid, h, vertices)) found.push_back(h);
    }
    return found;
}

/// Whether the path has one half-edge that fits, and which. Where many edges meet at its first vertex few may meet at
/// the second, so it is looked for from both in turn.
std::optional<HalfEdgeId> only_one(const Solid& solid, std::optional<FaceId> f, const std::vector<VertexId>& vertices)
{
    const auto fits = [&](HalfEdgeId h) {
        return solid.start(h) == vertices[0] && (!f || solid.face(h) == *f) && follows(solid, h, vertices);
    };
    const auto near = solid.fan(vertices[0]), far = solid.fan(vertices[vertices.size() > 1 ? 1 : 0]);
    std::vector<HalfEdgeId> from_near, from_far;
    auto a = near.begin();
    auto b = far.begin();
    for (; a != near.end() && b != far.end(); ++a, ++b) {
        if (fits(*a)) from_near.push_back(*a);
        if (const HalfEdgeId h = vertices.size() > 1 ? solid.prev(*b) : *b; fits(h)) from_far.push_back(h);
        if (from_near.size() > 1 || from_far.size() > 1) return std::nullopt;
    }
    const std::vector<HalfEdgeId>& all = a == near.end() ? from_near : from_far;
    return all.size() == 1 ? std::optional(all.front()) : std::nullopt;
}

constexpr std::size_t most_listed = 8;

std::string listed(const Named& in, const std::vector<HalfEdgeId>& halves)
{
    std::string text;
    for (std::size_t i = 0; i < halves.size() && i < most_listed; ++i)
        text += (i == 0 ? "" : ", ") + in.names.of(halves[i], in.solid);
    return halves.size() > most_listed ? text + ", ..." : text;
}

/// Nothing where none fits. \throws LineError where several do
std::optional<HalfEdgeId> the_one(const Named& in, std::optional<FaceId> f, const std::vector<VertexId>& vertices,
                                  std::string_view word)
{
    if (const auto h = only_one(in.solid, f, vertices)) return h;
    const std::vector<HalfEdgeId> halves = in_fan(in.solid, f, vertices, most_listed + 1);
    if (halves.empty()) return std::nullopt;
    throw error(ScriptFault::Ambiguous, {std::string(word), listed(in, halves)});
}

bool is_any(const Solid& solid, std::optional<FaceId> f, const std::vector<VertexId>& vertices)
{
    return !in_fan(solid, f, vertices, 1).empty();
}

HalfEdgeId in_face(const Named& in, std::optional<FaceId> f, HalfEdgeId h, std::string_view word)
{
    if (f && in.solid.face(h) != *f)
        throw error(ScriptFault::NoCornerInFace, {std::string(word), in.names.faces.of(*f)});
    return h;
}

} // namespace

std::optional<HalfEdgeId> find_numbered(const Named& in, std::string_view word)
{
    if (!word.starts_with('%')) return std::nullopt;
    std::uint32_t number = 0;
    const char* end = word.data() + word.size();
    const auto result = std::from_chars(word.data() + 1, end, number);
    const bool is_number = result.ec == std::errc() && result.ptr == end && number != 0;
    if (!is_number || !in.solid.has(HalfEdgeId{number - 1}))
        throw error(ScriptFault::NoHalfEdge, {std::string(word), std::string(in.name)});
    return HalfEdgeId{number - 1};
}

VertexId find_vertex(const Named& in, std::string_view word)
{
    if (const auto v = in.names.vertices.find(word, in.solid)) return *v;
    throw error(ScriptFault::NoVertex, {std::string(word), std::string(in.name)});
}

FaceId find_face(const Named& in, std::string_view word)
{
    if (const auto f = in.names.faces.find(word, in.solid)) return *f;
    throw error(ScriptFault::NoFace, {std::string(word), std::string(in.name)});
}

HalfEdgeId find_corner(const Named& in, FaceId f, std::string_view word)
{
    if (const auto h = find_numbered(in, word)) return in_face(in, f, *h, word);
    const std::vector<VertexId> vertices = path(in, word);
    if (const auto h = the_one(in, f, vertices, word)) return *h;
    if (is_any(in.solid, f, {vertices.front()}))
        throw error(ScriptFault::NoCornerInFace, {std::string(word), in.names.faces.of(f)});
    throw error(ScriptFault::NotInFace, {in.names.vertices.of(vertices.front()), in.names.faces.of(f)});
}

HalfEdgeId find_half_edge(const Named& in, std::string_view word)
{
    if (const auto h = find_numbered(in, word)) return *h;
    const std::vector<VertexId> vertices = path(in, word);
    if (const auto h = the_one(in, std::nullopt, vertices, word)) return *h;
    if (vertices.size() > 2) throw error(ScriptFault::NoHalfEdge, {std::string(word), std::string(in.name)});
    const NameList<VertexId>& names = in.names.vertices;
    throw error(ScriptFault::NoEdgeBetween, {names.of(vertices[0]), names.of(vertices[1])});
}

HalfEdgeId find_half_edge(const Named& in, std::optional<FaceId> f, std::string_view from, std::string_view to)
{
    const VertexId start = find_vertex(in, from);
    if (const auto h = find_numbered(in, to)) {
        if (in.solid.start(*h) != start) throw error(ScriptFault::WrongStart, {std::string(to), std::string(from)});
        return in_face(in, f, *h, to);
    }
    const std::vector<VertexId> vertices{start, find_vertex(in, to)};
    const std::string word = std::string(from) + ">" + std::string(to);
    if (const auto h = the_one(in, f, vertices, word)) return *h;
    if (f && is_any(in.solid, std::nullopt, vertices))
        throw error(ScriptFault::NoCornerInFace, {word, in.names.faces.of(*f)});
    throw error(ScriptFault::NoEdgeBetween, {std::string(from), std::string(to)});
}

std::string corner_word(const Named& in, HalfEdgeId h)
{
    const Solid& solid = in.solid;
    std::vector<VertexId> vertices{solid.start(h)};
    std::string word = in.names.vertices.of(vertices.front());
    for (HalfEdgeId step = h; vertices.size() <= 3; step = solid.next(step)) {
        if (only_one(solid, solid.face(h), vertices)) return word;
        vertices.push_back(solid.end(step));
        word += ">" + in.names.vertices.of(vertices.back());
    }
    return "%" + std::to_string(h.index + 1);
}

std::string end_word(const Named& in, HalfEdgeId h, std::optional<FaceId> f)
{
    const bool is_alone = only_one(in.solid, f, {in.solid.start(h), in.solid.end(h)}).has_value();
    return is_alone ? in.names.vertices.of(in.solid.end(h)) : "%" + std::to_string(h.index + 1);
}

} // namespace topology
