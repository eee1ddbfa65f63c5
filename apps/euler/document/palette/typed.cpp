#include <vector>

#include "apps/euler/document/palette/pending_operator.h"
#include "topology/script/corner.h"
#include "topology/script/script_fault.h"
#include "topology/text/words.h"
#include "ui/text/catalogue.h"

namespace euler {

namespace {

using topology::HalfEdgeId;
using topology::Named;
using topology::ScriptFault;
using ui::translatable;
using Words = std::vector<std::string_view>;

topology::Point point(const Words& words)
{
    if (words.size() > 3) throw error(ScriptFault::BadNumber, {std::string(words[3])});
    constexpr const char* names[3] = {"x", "y", "z"};
    if (words.size() < 3) throw topology::LineError(translatable("{0} is missing: write x y z"), {names[words.size()]});
    double coordinates[3] = {};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto value = topology::finite_number(words[i]);
        if (!value) throw error(ScriptFault::BadNumber, {std::string(words[i])});
        coordinates[i] = *value;
    }
    return {coordinates[0], coordinates[1], coordinates[2]};
}

/// "v1 v2" as an edge of a script, "f1 v1 v2" as one in a face; "f1 v1" as a corner of the face; "v1>v2", "%7", or the
/// one half-edge that starts at "v1" in any face.
HalfEdgeId half_edge(const Named& in, const Words& words)
{
    if (words.size() == 3) return find_half_edge(in, find_face(in, words[0]), words[1], words[2]);
    const bool is_edge = words.size() == 2 && !in.names.faces.find(words[0], in.solid);
    if (is_edge) return find_half_edge(in, std::nullopt, words[0], words[1]);
    if (words.size() == 2) return find_corner(in, find_face(in, words[0]), words[1]);
    return find_half_edge(in, words.front());
}

Choice read(const topology::ScriptRunner& runner, const PendingOperator& draft, const Words& words)
{
    const ArgumentKind kind = draft.next().kind;
    if (kind == ArgumentKind::Point || kind == ArgumentKind::Vector) return point(words);
    if (words.empty()) throw error(ScriptFault::BadName, {""});
    const auto place = draft.solid(runner);
    if (!place) return std::string(words.front());
    const Named in = runner.solids()[*place].named();
    switch (kind) {
    case ArgumentKind::Face: return find_face(in, words.front());
    case ArgumentKind::Vertex: return find_vertex(in, words.front());
    case ArgumentKind::Corner:
    case ArgumentKind::HalfEdge:
    case ArgumentKind::Ring: return half_edge(in, words);
    default: return std::string(words.front());
    }
}

} // namespace

std::variant<Choice, ui::Message> typed(const topology::ScriptRunner& runner, const PendingOperator& draft,
                                        std::string_view text)
{
    try {
        return read(runner, draft, topology::words(text));
    } catch (const topology::LineError& fault) {
        return reason(fault);
    }
}

} // namespace euler
