#include "tests/topology/halfedge/random_walk.h"

#include <array>

using namespace topology;

namespace {

constexpr std::array makers{OperatorKind::MVFS, OperatorKind::MEV,   OperatorKind::MEV,   OperatorKind::SEMV,
                            OperatorKind::MVR,  OperatorKind::MEF,   OperatorKind::MEF,   OperatorKind::MEKR,
                            OperatorKind::KEMR, OperatorKind::KFMRH, OperatorKind::MFKRH, OperatorKind::RINGMV,
                            OperatorKind::MOVE};
constexpr std::array killers{OperatorKind::KVFS, OperatorKind::KEV,   OperatorKind::KEV,  OperatorKind::JEKV,
                             OperatorKind::KVR,  OperatorKind::KEF,   OperatorKind::KEF,  OperatorKind::KEMR,
                             OperatorKind::MEKR, OperatorKind::KFMRH, OperatorKind::MFKRH};

template <class Table> auto any_of(const Table& table, RandomWalk& walk)
{
    using Id = decltype(table.last());
    while (true)
        if (const Id id{walk.below(table.n_rows())}; table.has(id)) return id;
}

} // namespace

HalfEdgeId RandomWalk::any_half_edge() { return any_of(solid.half_edges(), *this); }
FaceId RandomWalk::any_face() { return any_of(solid.faces(), *this); }
LoopId RandomWalk::any_loop() { return any_of(solid.loops(), *this); }

HalfEdgeId RandomWalk::some_in_fan(HalfEdgeId h)
{
    for (std::uint32_t n = below(4); n != 0; --n) h = solid.next_around_vertex(h);
    return h;
}

HalfEdgeId RandomWalk::some_in_chain(HalfEdgeId h)
{
    for (std::uint32_t n = below(6); n != 0; --n) h = solid.next(h);
    return h;
}

Point RandomWalk::any_point()
{
    const auto coordinate = [&] { return static_cast<double>(below(1000)); };
    return {coordinate(), coordinate(), coordinate()};
}

OperatorKind RandomWalk::any_kind(double growth)
{
    if (std::uniform_real_distribution<double>(0.0, 1.0 + growth)(random_) < growth)
        return makers[below(makers.size())];
    return killers[below(killers.size())];
}

OperatorKind RandomWalk::step(double growth)
{
    while (true) {
        const OperatorKind kind = solid.is_empty() ? OperatorKind::MVFS : any_kind(growth);
        if (kind == OperatorKind::MVFS && !solid.is_empty() && below(8) != 0) continue; // few shells, much joined
        if (attempt(kind)) return kind;
    }
}

bool RandomWalk::attempt(OperatorKind kind)
{
    switch (kind) {
    case OperatorKind::MVFS: make_.mvfs(any_point()); return true;
    case OperatorKind::MVR: make_.mvr(any_face(), any_point()); return true;
    case OperatorKind::MOVE: make_.move(solid.start(any_half_edge()), any_point()); return true;
    case OperatorKind::KVFS:
    case OperatorKind::KVR:
    case OperatorKind::KFMRH:
    case OperatorKind::MFKRH:
    case OperatorKind::RINGMV: return attempt_on_faces(kind);
    default: return attempt_on_edges(kind);
    }
}

bool RandomWalk::attempt_on_edges(OperatorKind kind)
{
    const HalfEdgeId h = any_half_edge();
    switch (kind) {
    case OperatorKind::MEV: return make_.mev(h, some_in_fan(h), any_point()), true;
    case OperatorKind::MEF: return make_.mef(h, some_in_chain(h)), true;
    case OperatorKind::SEMV: return !make_.why_not_semv(h) && (make_.semv(h, any_point()), true);
    case OperatorKind::KEV: return !make_.why_not_kev(h) && (make_.kev(h), true);
    case OperatorKind::JEKV: return !make_.why_not_jekv(h) && (make_.jekv(h), true);
    case OperatorKind::KEF: return !make_.why_not_kef(h) && (make_.kef(h), true);
    case OperatorKind::KEMR: return !make_.why_not_kemr(h) && (make_.kemr(h), true);
    default: break;
    }
    LoopId l = solid.loop(h);
    for (std::uint32_t n = 1 + below(3); n != 0; --n) l = solid.tables().loops[l].next;
    const HalfEdgeId other = some_in_chain(solid.half_edge(l));
    return !make_.why_not_mekr(h, other) && (make_.mekr(h, other), true);
}

bool RandomWalk::attempt_on_faces(OperatorKind kind)
{
    const FaceId f = any_face(), g = any_face();
    const LoopId l = any_loop();
    switch (kind) {
    case OperatorKind::KVFS: return !make_.why_not_kvfs(f) && (make_.kvfs(f), true);
    case OperatorKind::KVR: return !make_.why_not_kvr(l) && (make_.kvr(l), true);
    case OperatorKind::KFMRH: return !make_.why_not_kfmrh(f, g) && (make_.kfmrh(f, g), true);
    case OperatorKind::MFKRH: return !make_.why_not_mfkrh(l) && (make_.mfkrh(l), true);
    default: return !make_.why_not_ringmv(l, f) && (make_.ringmv(l, f), true);
    }
}
