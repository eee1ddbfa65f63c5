#include "topology/script/corner.h"

#include <charconv>
#include <vector>

#include "topology/script/script_fault.h"

namespace topology {

namespace {

std::vector<VertexId> path(const Named& in, std::string_view word)
{
    std::vector<VertexId> vertices;
    while (true) {
        const auto mark = word.find('>');
        vertices.push_back(find_vertex(in, word.substr(0, mark)));
        if (mark == std::string_view::npos) return vertices;
        word.remove_prefix(mark + 1);
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

std::vector<HalfEdgeId> that_fit(const Solid& solid, std::optional<FaceId> f, const std::vector<VertexId>& vertices)
{
    std::vector<HalfEdgeId> found;
    for (const HalfEdgeId h : solid.fan(vertices.front()))
        if ((!f || solid.face(h) == *f) && follows(solid, h, vertices)) found.push_back(h);
    return found;
}

std::string listed(const Named& in, const std::vector<HalfEdgeId>& halves)
{
    constexpr std::size_t most = 8;
    std::string text;
    for (std::size_t i = 0; i < halves.size() && i < most; ++i)
        text += (i == 0 ? "" : ", ") + in.names.of(halves[i], in.solid);
    return halves.size() > most ? text + ", ..." : text;
}

HalfEdgeId the_one(const Named& in, const std::string& word, const std::vector<HalfEdgeId>& halves)
{
    if (halves.size() > 1) throw error(ScriptFault::Ambiguous, {word, listed(in, halves)});
    return halves.front();
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
    const std::vector<HalfEdgeId> halves = that_fit(in.solid, f, vertices);
    if (!halves.empty()) return the_one(in, std::string(word), halves);
    const bool is_vertex_there = !that_fit(in.solid, f, {vertices.front()}).empty();
    if (is_vertex_there) throw error(ScriptFault::NoCornerInFace, {std::string(word), in.names.faces.of(f)});
    throw error(ScriptFault::NotInFace, {in.names.vertices.of(vertices.front()), in.names.faces.of(f)});
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
    const std::vector<HalfEdgeId> halves = that_fit(in.solid, f, vertices);
    if (!halves.empty()) return the_one(in, word, halves);
    if (f && !that_fit(in.solid, std::nullopt, vertices).empty())
        throw error(ScriptFault::NoCornerInFace, {word, in.names.faces.of(*f)});
    throw error(ScriptFault::NoEdgeBetween, {std::string(from), std::string(to)});
}

std::string corner_word(const Named& in, HalfEdgeId h)
{
    const Solid& solid = in.solid;
    std::vector<VertexId> vertices{solid.start(h)};
    std::string word = in.names.vertices.of(vertices.front());
    for (HalfEdgeId step = h; vertices.size() <= 3; step = solid.next(step)) {
        if (that_fit(solid, solid.face(h), vertices).size() == 1) return word;
        vertices.push_back(solid.end(step));
        word += ">" + in.names.vertices.of(vertices.back());
    }
    return "%" + std::to_string(h.index + 1);
}

std::string end_word(const Named& in, HalfEdgeId h, std::optional<FaceId> f)
{
    const bool is_alone = that_fit(in.solid, f, {in.solid.start(h), in.solid.end(h)}).size() == 1;
    return is_alone ? in.names.vertices.of(in.solid.end(h)) : "%" + std::to_string(h.index + 1);
}

} // namespace topology
