#include "apps/euler/document/palette/legality.h"

#include "apps/euler/document/stepper.h"
#include "topology/modeling/sweep.h"
#include "topology/script/script_fault.h"
#include "topology/script/wording.h"
#include "ui/text/catalogue.h"

namespace euler {

namespace {

using topology::Entity;
using topology::EntityKind;
using topology::FaceId;
using topology::HalfEdgeId;
using topology::LoopId;
using topology::NamedSolid;
using topology::Refusal;
using topology::RefusalKind;
using topology::Solid;
using topology::VertexId;
using ui::Message;
using ui::translatable;

std::string_view wrong_kind(ArgumentKind wanted)
{
    switch (wanted) {
    case ArgumentKind::Face: return translatable("{what} is no face");
    case ArgumentKind::Vertex: return translatable("{what} is no vertex");
    case ArgumentKind::Ring: return translatable("{what} is no ring, nor a half-edge of one");
    default: return translatable("{what} is no half-edge");
    }
}

bool is_wanted(EntityKind kind, ArgumentKind wanted)
{
    switch (wanted) {
    case ArgumentKind::Face: return kind == EntityKind::Face;
    case ArgumentKind::Vertex: return kind == EntityKind::Vertex;
    case ArgumentKind::Ring: return kind == EntityKind::HalfEdge || kind == EntityKind::Loop;
    default: return kind == EntityKind::HalfEdge;
    }
}

bool lives(const Solid& solid, Entity entity)
{
    switch (entity.kind) {
    case EntityKind::Face: return solid.has(FaceId{entity.index});
    case EntityKind::Loop: return solid.has(LoopId{entity.index});
    case EntityKind::Edge: return solid.has(topology::EdgeId{entity.index});
    case EntityKind::HalfEdge: return solid.has(HalfEdgeId{entity.index});
    case EntityKind::Vertex: return solid.has(VertexId{entity.index});
    }
    return false;
}

/// The picked entities, as what the operator takes them for.
struct Picks {
    const Solid& solid;
    const std::vector<Entity>& all;

    std::size_t size() const { return all.size(); }
    HalfEdgeId half(std::size_t i) const { return {all[i].index}; }
    FaceId face(std::size_t i) const { return {all[i].index}; }
    VertexId vertex(std::size_t i) const { return {all[i].index}; }
    LoopId loop(std::size_t i) const
    {
        return all[i].kind == EntityKind::Loop ? LoopId{all[i].index} : solid.loop(half(i));
    }
    HalfEdgeId ring_corner(std::size_t i) const
    {
        return all[i].kind == EntityKind::Loop ? solid.half_edge(LoopId{all[i].index}) : half(i);
    }
};

/// Of the operators that are given one entity.
std::optional<Refusal> refusal_of_one(const topology::EulerOperator& op, Verb verb, const Picks& picks)
{
    const Solid& solid = op.solid();
    switch (verb) {
    case Verb::Kvfs: return op.why_not_kvfs(picks.face(0));
    case Verb::Kev: return op.why_not_kev(solid.mate(picks.half(0)));
    case Verb::Kef: return op.why_not_kef(picks.half(0));
    case Verb::Kemr: return op.why_not_kemr(picks.half(0));
    case Verb::Mfkrh:
    case Verb::Ringmv: return op.why_not_mfkrh(picks.loop(0));
    case Verb::Kvr: return op.why_not_kvr(solid.loop(solid.half_edge(picks.vertex(0))));
    case Verb::Split:
    case Verb::Semv: return op.why_not_semv(picks.half(0));
    case Verb::Jekv: return op.why_not_jekv(solid.mate(picks.half(0)));
    case Verb::Sweep: return why_not_sweep(op, picks.face(0));
    default: return std::nullopt;
    }
}

std::optional<Refusal> refusal_of_two(const topology::EulerOperator& op, Verb verb, const Picks& picks)
{
    switch (verb) {
    case Verb::Split: return op.why_not_mev(picks.half(0), picks.half(1));
    case Verb::Mef: return op.why_not_mef(picks.half(0), picks.half(1));
    case Verb::Mekr: return op.why_not_mekr(picks.half(0), picks.half(1));
    case Verb::Kfmrh: return op.why_not_kfmrh(picks.face(0), picks.face(1));
    case Verb::Ringmv: return op.why_not_ringmv(picks.loop(0), picks.face(1));
    default: return std::nullopt;
    }
}

Message message(const Refusal& refusal, const NamedSolid& in)
{
    Message said(topology::pattern(refusal.kind));
    for (std::size_t i = 0; i < refusal.entities.size(); ++i)
        said.arguments.emplace_back(std::to_string(i), in.names.of(refusal.entities[i], in.solid));
    return said;
}

/// What the script language refuses though the operator would not, and what can be seen before the second pick.
std::optional<Message> refused_early(const NamedSolid& in, Verb verb, const Picks& picks)
{
    if (verb == Verb::Split && picks.size() == 2 && picks.half(0) == picks.half(1))
        return reason(topology::error(topology::ScriptFault::SameHalfEdge, {in.names.of(picks.all[0], in.solid)}));
    if (verb != Verb::Mekr || picks.size() != 1) return std::nullopt;
    const LoopId l = in.solid.loop(picks.half(0));
    if (in.solid.loops()[l].next != l) return std::nullopt;
    return Message(translatable("face {face} has one loop; MEKR needs two"),
                   {{"face", in.names.faces.of(in.solid.face(l))}});
}

} // namespace

std::optional<Message> Legality::why_not(Verb verb, ArgumentKind wanted, const std::vector<Entity>& picked)
{
    const Entity last = picked.back();
    if (!is_wanted(last.kind, wanted)) return Message(wrong_kind(wanted), {{"what", in_.names.of(last, in_.solid)}});
    if (!lives(in_.solid, last)) return message({.kind = RefusalKind::NoSuchEntity, .entities = {last}}, in_);
    const Picks picks{in_.solid, picked};
    if (auto early = refused_early(in_, verb, picks)) return early;
    const topology::EulerOperator op(copy_);
    const auto refusal = picked.size() == 1 ? refusal_of_one(op, verb, picks) : refusal_of_two(op, verb, picks);
    return refusal ? std::optional(message(*refusal, in_)) : std::nullopt;
}

std::string pointed_text(const NamedSolid& in, Verb verb, const std::vector<Entity>& picked)
{
    const topology::Wording say(in.named());
    const Picks picks{in.solid, picked};
    switch (verb) {
    case Verb::Mvfs: return "";
    case Verb::Mev: return say.face_of(picks.half(0)) + say.corner(picks.half(0));
    case Verb::Mef:
    case Verb::Mekr: return say.face_of(picks.half(0)) + say.corner(picks.half(0)) + say.corner(picks.half(1));
    case Verb::Split: return say.split(picks.half(0), picks.half(1));
    case Verb::Kev:
    case Verb::Semv:
    case Verb::Jekv: return say.ends(picks.half(0));
    case Verb::Kef:
    case Verb::Kemr: return say.face_of(picks.half(0)) + say.ends_in_face(picks.half(0));
    case Verb::Kvfs:
    case Verb::Mvr:
    case Verb::Sweep: return say.face(picks.face(0));
    case Verb::Kfmrh: return say.face(picks.face(0)) + say.face(picks.face(1));
    case Verb::Mfkrh: return say.face(in.solid.face(picks.loop(0))) + say.corner(picks.ring_corner(0));
    case Verb::Kvr: return say.face_of(in.solid.half_edge(picks.vertex(0))) + say.vertex(picks.vertex(0));
    case Verb::Move: return say.vertex(picks.vertex(0));
    case Verb::Ringmv:
        return say.face(in.solid.face(picks.loop(0))) + say.corner(picks.ring_corner(0)) + say.face(picks.face(1));
    }
    return "";
}

} // namespace euler
