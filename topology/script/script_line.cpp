#include "topology/script/script_line.h"

#include <algorithm>
#include <cctype>
#include <charconv>

#include "topology/geometry/vector.h"
#include "topology/halfedge/check/shells.h"
#include "topology/text/words.h"

namespace topology {

namespace {

bool begins_name(char c)
{
    const auto code = static_cast<unsigned char>(c);
    return std::isalpha(code) != 0 || code >= 0x80U; // the letters of other languages, in UTF-8
}

bool is_name(std::string_view word)
{
    return !word.empty() && begins_name(word.front()) && is_utf8(word) &&
           word.find_first_of(">%#") == std::string_view::npos &&
           std::none_of(word.begin(), word.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20U; });
}

std::string new_name(std::string_view word)
{
    if (!is_name(word)) throw error(ScriptFault::BadName, {std::string(word)});
    return std::string(word);
}

double number(std::string_view word)
{
    if (const auto value = finite_number(word)) return *value;
    throw error(ScriptFault::BadNumber, {std::string(word)});
}

std::size_t amount(std::string_view word)
{
    std::size_t value = 0;
    const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
    if (result.ec != std::errc() || result.ptr != word.data() + word.size() || value == 0)
        throw error(ScriptFault::BadAmount, {std::string(word)});
    return value;
}

template <class Id>
std::string free_name(const NameList<Id>& list, std::string_view word, const Solid& solid, std::string_view solid_name)
{
    if (list.find(word, solid)) throw error(ScriptFault::NameInUse, {std::string(word), std::string(solid_name)});
    return new_name(word);
}

} // namespace

const std::array<ScriptLine::Operation, 20> ScriptLine::operations{{
    {"mvfs S F V x y z", &ScriptLine::mvfs},
    {"kvfs S [F]", &ScriptLine::kvfs},
    {"mev S F C V2 x y z", &ScriptLine::mev},
    {"split S F1 F2 V1 Va Vb V2 x y z", &ScriptLine::split},
    {"kev S V1 V2", &ScriptLine::kev},
    {"mef S F C1 C3 F2", &ScriptLine::mef},
    {"kef S F V1 V3", &ScriptLine::kef},
    {"kemr S F V1 V2", &ScriptLine::kemr},
    {"mekr S F C1 C2", &ScriptLine::mekr},
    {"kfmrh S F1 F2", &ScriptLine::kfmrh},
    {"mfkrh S F1 C F2", &ScriptLine::mfkrh},
    {"mvr S F V x y z", &ScriptLine::mvr},
    {"kvr S F V", &ScriptLine::kvr},
    {"semv S V1 V2 Vn x y z", &ScriptLine::semv},
    {"jekv S V1 Vn", &ScriptLine::jekv},
    {"ringmv S F1 C F2", &ScriptLine::ringmv},
    {"move S V x y z", &ScriptLine::move},
    {"sweep S F dx dy dz", &ScriptLine::sweep},
    {"undo [n]", &ScriptLine::undo_or_redo, false},
    {"redo [n]", &ScriptLine::undo_or_redo, false},
}};

LineKind ScriptLine::run()
{
    const auto named = [&](std::string_view word) { return std::ranges::find(operations, word, &Operation::word); };
    const auto operation = named(words_[0]);
    if (operation == operations.end()) {
        std::string small(words_[0]);
        for (char& letter : small)
            if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
        const bool is_capital = named(small) != operations.end();
        throw is_capital ? error(ScriptFault::CapitalWord, {small})
                         : error(ScriptFault::UnknownWord, {std::string(words_[0])});
    }
    if (!operation->takes(words_.size()))
        throw error(ScriptFault::WrongCount, {std::string(words_[0]), std::string(operation->usage)});
    (this->*operation->run)();
    return operation->is_step ? LineKind::Operator : LineKind::UndoOrRedo;
}

std::string ScriptLine::new_vertex(std::size_t i)
{
    return free_name(solid().names.vertices, words_[i], solid().solid, solid().name);
}

std::string ScriptLine::new_face(std::size_t i)
{
    return free_name(solid().names.faces, words_[i], solid().solid, solid().name);
}

Point ScriptLine::point(std::size_t i) const
{
    return {number(words_[i]), number(words_[i + 1]), number(words_[i + 2])};
}

void ScriptLine::mvfs()
{
    const Point p = point(4);
    place_ = runner_.find(words_[1]);
    const bool is_new = !place_;
    const std::string face_name = is_new ? new_name(words_[2]) : new_face(2);
    const std::string vertex_name = is_new ? new_name(words_[3]) : new_vertex(3);
    if (is_new) {
        const std::string name = new_name(words_[1]);
        runner_.forget_undone();
        place_ = runner_.solids_.size();
        runner_.add({.name = name});
    }
    NamedSolid& in = runner_.solids_[*place_];
    const LoneVertex made = observed(in).mvfs(p);
    runner_.commit(*place_, 1);
    in.names.faces.give(made.face, face_name);
    in.names.vertices.give(made.vertex, vertex_name);
}

void ScriptLine::kvfs()
{
    const Solid& s = solid().solid;
    const bool has_several_shells = words_.size() == 2 && s.counts().faces > 1 && shells(s).size() > 1;
    if (has_several_shells) throw error(ScriptFault::WhichShell, {solid().name});
    const FaceId f = words_.size() == 2 ? *s.faces().begin() : face(2);
    apply([&](EulerOperator& op) { op.kvfs(f); });
}

void ScriptLine::mev()
{
    const HalfEdgeId c = corner(face(2), 3);
    const std::string name = new_vertex(4);
    const Point p = point(5);
    name_vertex(apply([&](EulerOperator& op) { return op.mev(c, p); }).vertex, name);
}

void ScriptLine::split()
{
    const HalfEdgeId from = half_edge(face(2), 4, 5), to = half_edge(face(3), 4, 6);
    if (from == to) throw error(ScriptFault::SameHalfEdge, {solid().names.of(from, solid().solid)});
    const std::string name = new_vertex(7);
    const Point p = point(8);
    name_vertex(apply([&](EulerOperator& op) { return op.mev(from, to, p); }).vertex, name);
}

void ScriptLine::kev()
{
    const HalfEdgeId h = half_edge(std::nullopt, 2, 3);
    apply([&](EulerOperator& op) { op.kev(op.solid().mate(h)); });
}

void ScriptLine::mef()
{
    const FaceId f = face(2);
    const HalfEdgeId from = corner(f, 3), to = corner(f, 4);
    const std::string name = new_face(5);
    name_face(apply([&](EulerOperator& op) { return op.mef(from, to); }).face, name);
}

void ScriptLine::kef()
{
    const HalfEdgeId h = half_edge(face(2), 3, 4);
    apply([&](EulerOperator& op) { op.kef(h); });
}

void ScriptLine::kemr()
{
    const HalfEdgeId h = half_edge(face(2), 3, 4);
    apply([&](EulerOperator& op) { op.kemr(h); });
}

void ScriptLine::mekr()
{
    const FaceId f = face(2);
    const HalfEdgeId from = corner(f, 3), to = corner(f, 4);
    apply([&](EulerOperator& op) { op.mekr(from, to); });
}

void ScriptLine::kfmrh()
{
    const FaceId host = face(2), f = face(3);
    apply([&](EulerOperator& op) { op.kfmrh(host, f); });
}

void ScriptLine::mfkrh()
{
    const LoopId ring = solid().solid.loop(corner(face(2), 3));
    const std::string name = new_face(4);
    name_face(apply([&](EulerOperator& op) { return op.mfkrh(ring); }), name);
}

void ScriptLine::mvr()
{
    const FaceId f = face(2);
    const std::string name = new_vertex(3);
    const Point p = point(4);
    name_vertex(apply([&](EulerOperator& op) { return op.mvr(f, p); }).vertex, name);
}

void ScriptLine::kvr()
{
    const FaceId f = face(2);
    const Solid& s = solid().solid;
    const LoopId ring = s.loop(s.half_edge(vertex(3)));
    if (!s.is_lone(ring) || s.face(ring) != f)
        throw error(ScriptFault::NoRing, {std::string(words_[3]), std::string(words_[2])});
    apply([&](EulerOperator& op) { op.kvr(ring); });
}

void ScriptLine::semv()
{
    const HalfEdgeId h = half_edge(std::nullopt, 2, 3);
    const std::string name = new_vertex(4);
    const Point p = point(5);
    name_vertex(apply([&](EulerOperator& op) { return op.semv(h, p); }).vertex, name);
}

void ScriptLine::jekv()
{
    const HalfEdgeId h = half_edge(std::nullopt, 2, 3);
    apply([&](EulerOperator& op) { op.jekv(op.solid().mate(h)); });
}

void ScriptLine::ringmv()
{
    const LoopId ring = solid().solid.loop(corner(face(2), 3));
    const FaceId to = face(4);
    apply([&](EulerOperator& op) { op.ringmv(ring, to); });
}

void ScriptLine::move()
{
    const VertexId v = vertex(2);
    const Point p = point(3);
    apply([&](EulerOperator& op) { op.move(v, p); });
}

void ScriptLine::sweep()
{
    const FaceId f = face(2);
    const Point end = point(3);
    const Vector by = end - Point{};
    NamedSolid& in = solid();
    EulerOperator op = observed(in);
    if (const auto refusal = why_not_sweep(op, f)) throw description(*refusal);
    for (const LoopId l : in.solid.loops(f))
        for (const HalfEdgeId h : in.solid.chain(l))
            if (const VertexId v = in.solid.start(h); !is_finite(in.solid.point(v) + by))
                throw error(ScriptFault::BeyondRange, {in.names.vertices.of(v)});
    const std::string face_name = in.names.faces.of(f);
    const std::size_t n_before = in.journal.n_done();
    const Sweep made = topology::sweep(op, f, by);
    runner_.commit(*place_, in.journal.n_done() - n_before);
    name_sweep(made, face_name);
}

/// A new name is free while nothing alive bears it, so each is given before the next is looked for.
void ScriptLine::name_sweep(const Sweep& made, const std::string& face_name)
{
    NamedSolid& in = solid();
    Names& names = in.names;
    for (const SweptVertex& v : made.vertices)
        names.vertices.give(v.image, names.vertices.unused(names.vertices.of(v.from) + "'", in.solid));
    for (const SweptSide& side : made.sides) {
        const std::string name = face_name + "." + names.vertices.of(side.from) + "." + names.vertices.of(side.to);
        names.faces.give(side.face, names.faces.unused(name, in.solid));
    }
}

void ScriptLine::undo_or_redo()
{
    const std::size_t n = words_.size() == 2 ? amount(words_[1]) : 1;
    if (words_[0] == "undo") runner_.undo(n);
    else runner_.redo(n);
}

} // namespace topology
