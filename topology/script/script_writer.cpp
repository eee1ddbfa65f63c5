#include "topology/script/script_writer.h"

#include <utility>

#include "topology/modeling/construction.h"
#include "topology/text/words.h"

namespace topology {

namespace {

std::string spaced(const Point& p) { return " " + written(p.x) + " " + written(p.y) + " " + written(p.z); }

/// Plays a journal from the beginning and writes down each step: the corners as they are named before it, what it makes
/// after it.
class Writer {
public:
    explicit Writer(const NamedSolid& solid)
        : names_(solid.names), name_(solid.name), solid_(solid.solid), journal_(solid.journal), op_(solid_, journal_)
    {
        while (journal_.n_done() != 0) op_.undo();
    }

    std::string take()
    {
        while (journal_.n_undone() != 0) write(journal_[journal_.n_done()]);
        return std::move(text_);
    }

private:
    Named in() const { return {solid_, names_, name_}; }
    std::string face(FaceId f) const { return " " + names_.faces.of(f); }
    std::string vertex(VertexId v) const { return " " + names_.vertices.of(v); }
    std::string face_of(HalfEdgeId h) const { return face(solid_.face(h)); }
    std::string corner(HalfEdgeId h) const { return " " + corner_word(in(), h); }
    std::string corner(LoopId l) const { return corner(solid_.half_edge(l)); }
    /// "V1 V2": the edge along h.
    std::string ends(HalfEdgeId h, bool is_in_face) const
    {
        const std::optional<FaceId> f = is_in_face ? std::optional(solid_.face(h)) : std::nullopt;
        return vertex(solid_.start(h)) + " " + end_word(in(), h, f);
    }

    void write(Step step)
    {
        const std::string line = operation(step);
        op_.redo();
        text_ += line + made(step) + "\n";
    }

    /// The line up to what it makes.
    std::string operation(const Step& step) const
    {
        const HalfEdgeId a = step.first(), b = step.second();
        const FaceId f{step.a};
        const LoopId l{step.a};
        switch (step.kind) {
        case OperatorKind::MVFS: return "mvfs " + name_;
        case OperatorKind::KVFS: return "kvfs " + name_ + face(f);
        case OperatorKind::MEV: return a == b ? "mev " + name_ + face_of(a) + corner(a) : split(a, b);
        case OperatorKind::KEV: return "kev " + name_ + ends(b, false);
        case OperatorKind::SEMV: return "semv " + name_ + ends(a, false);
        case OperatorKind::JEKV: return "jekv " + name_ + ends(b, false);
        case OperatorKind::MVR: return "mvr " + name_ + face(f);
        case OperatorKind::KVR:
            return "kvr " + name_ + face(solid_.face(l)) + vertex(solid_.start(solid_.half_edge(l)));
        case OperatorKind::MEF: return "mef " + name_ + face_of(a) + corner(a) + corner(b);
        case OperatorKind::KEF: return "kef " + name_ + face_of(a) + ends(a, true);
        case OperatorKind::KEMR: return "kemr " + name_ + face_of(a) + ends(a, true);
        case OperatorKind::MEKR: return "mekr " + name_ + face_of(a) + corner(a) + corner(b);
        case OperatorKind::KFMRH: return "kfmrh " + name_ + face(f) + face(FaceId{step.b});
        case OperatorKind::MFKRH: return "mfkrh " + name_ + face(solid_.face(l)) + corner(l);
        case OperatorKind::RINGMV: return "ringmv " + name_ + face(solid_.face(l)) + corner(l) + face(FaceId{step.b});
        case OperatorKind::MOVE: break;
        }
        return "move " + name_ + vertex(VertexId{step.a});
    }
    std::string split(HalfEdgeId from, HalfEdgeId to) const
    {
        return "split " + name_ + face_of(from) + face_of(to) + vertex(solid_.start(from)) + " " +
               end_word(in(), from, solid_.face(from)) + " " + end_word(in(), to, solid_.face(to));
    }

    std::string made(const Step& step) const
    {
        const VertexId v{step.other};
        switch (step.kind) {
        case OperatorKind::MVFS: return face(solid_.face(solid_.half_edge(v))) + vertex(v) + spaced(solid_.point(v));
        case OperatorKind::MEV:
        case OperatorKind::SEMV:
        case OperatorKind::MVR: return vertex(v) + spaced(solid_.point(v));
        case OperatorKind::MEF:
        case OperatorKind::MFKRH: return face(FaceId{step.other});
        case OperatorKind::MOVE: return spaced(solid_.point(VertexId{step.a}));
        default: return "";
        }
    }

    const Names& names_;
    std::string name_;
    Solid solid_;
    Journal journal_;
    EulerOperator op_;
    std::string text_;
};

} // namespace

std::string journal_script(const NamedSolid& solid) { return Writer(solid).take(); }

std::string construction_script(const NamedSolid& solid)
{
    Construction made = construction(solid.solid);
    NamedSolid again{
        .name = solid.name, .solid = std::move(made.solid), .journal = std::move(made.journal), .names = {}};
    for (std::uint32_t v = 0; v < made.vertex_of.size(); ++v)
        again.names.vertices.give(VertexId{v}, solid.names.vertices.of(made.vertex_of[v]));
    for (std::uint32_t f = 0; f < made.face_of.size(); ++f)
        if (made.face_of[f] != nothing<FaceId>)
            again.names.faces.give(FaceId{f}, solid.names.faces.of(made.face_of[f]));
    for (std::uint32_t f = 0; f < made.face_of.size(); ++f) {
        std::string helper = "h" + std::to_string(f + 1);
        while (made.face_of[f] == nothing<FaceId> && again.names.faces.is_given(helper)) helper += '\'';
        if (made.face_of[f] == nothing<FaceId>) again.names.faces.give(FaceId{f}, helper);
    }
    return journal_script(again);
}

} // namespace topology
