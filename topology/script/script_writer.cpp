#include "topology/script/script_writer.h"

#include <utility>

#include "topology/modeling/construction.h"
#include "topology/script/wording.h"

namespace topology {

namespace {

/// Plays the last operators of a journal again and writes down each step: the corners as they are named before it, what
/// it makes after it.
class Writer {
public:
    Writer(const NamedSolid& solid, std::size_t n_operators)
        : names_(solid.names),
          name_(solid.name),
          solid_(solid.solid),
          journal_(solid.journal),
          op_(solid_, journal_),
          say_({solid_, names_, name_})
    {
        for (; n_left_ != n_operators; ++n_left_) op_.undo();
    }

    std::string take()
    {
        for (; n_left_ != 0; --n_left_) write(journal_[journal_.n_done()]);
        return std::move(text_);
    }

private:
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
        case OperatorKind::KVFS: return "kvfs " + name_ + say_.face(f);
        case OperatorKind::MEV:
            return a == b ? "mev " + name_ + say_.face_of(a) + say_.corner(a) : "split " + name_ + say_.split(a, b);
        case OperatorKind::KEV: return "kev " + name_ + say_.ends(b);
        case OperatorKind::SEMV: return "semv " + name_ + say_.ends(a);
        case OperatorKind::JEKV: return "jekv " + name_ + say_.ends(b);
        case OperatorKind::MVR: return "mvr " + name_ + say_.face(f);
        case OperatorKind::KVR:
            return "kvr " + name_ + say_.face(solid_.face(l)) + say_.vertex(solid_.start(solid_.half_edge(l)));
        case OperatorKind::MEF: return "mef " + name_ + say_.face_of(a) + say_.corner(a) + say_.corner(b);
        case OperatorKind::KEF: return "kef " + name_ + say_.face_of(a) + say_.ends_in_face(a);
        case OperatorKind::KEMR: return "kemr " + name_ + say_.face_of(a) + say_.ends_in_face(a);
        case OperatorKind::MEKR: return "mekr " + name_ + say_.face_of(a) + say_.corner(a) + say_.corner(b);
        case OperatorKind::KFMRH: return "kfmrh " + name_ + say_.face(f) + say_.face(FaceId{step.b});
        case OperatorKind::MFKRH: return "mfkrh " + name_ + say_.face(solid_.face(l)) + say_.corner(l);
        case OperatorKind::RINGMV:
            return "ringmv " + name_ + say_.face(solid_.face(l)) + say_.corner(l) + say_.face(FaceId{step.b});
        case OperatorKind::MOVE: break;
        }
        return "move " + name_ + say_.vertex(VertexId{step.a});
    }
    std::string made(const Step& step) const
    {
        const VertexId v{step.other};
        switch (step.kind) {
        case OperatorKind::MVFS:
            return say_.face(solid_.face(solid_.half_edge(v))) + say_.vertex(v) + say_.point(solid_.point(v));
        case OperatorKind::MEV:
        case OperatorKind::SEMV:
        case OperatorKind::MVR: return say_.vertex(v) + say_.point(solid_.point(v));
        case OperatorKind::MEF:
        case OperatorKind::MFKRH: return say_.face(FaceId{step.other});
        case OperatorKind::MOVE: return say_.point(solid_.point(VertexId{step.a}));
        default: return "";
        }
    }

    const Names& names_;
    std::string name_;
    Solid solid_;
    Journal journal_;
    EulerOperator op_;
    Wording say_;
    std::size_t n_left_ = 0;
    std::string text_;
};

} // namespace

std::string journal_script(const NamedSolid& solid) { return journal_script(solid, solid.journal.n_done()); }

std::string journal_script(const NamedSolid& solid, std::size_t n_operators)
{
    return Writer(solid, n_operators).take();
}

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
