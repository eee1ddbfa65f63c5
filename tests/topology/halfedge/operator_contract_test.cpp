// What every operator promises, on many random sound states.
#include <doctest/doctest.h>

#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/topology/halfedge/random_walk.h"
#include "topology/halfedge/check/shells.h"
#include "topology/halfedge/check/validate.h"

using namespace topology;

namespace {

constexpr int n_kinds = 16;

/// Changes of V, E, F, L, S, G.
struct Delta {
    int V = 0, E = 0, F = 0, L = 0, S = 0, G = 0;

    friend auto operator<=>(const Delta&, const Delta&) = default;
};

Delta difference(const EulerCounts& a, const EulerCounts& b)
{
    const auto minus = [](std::size_t x, std::size_t y) { return static_cast<int>(x) - static_cast<int>(y); };
    return {minus(b.V, a.V), minus(b.E, a.E), minus(b.F, a.F), minus(b.L, a.L), minus(b.S, a.S), minus(b.G, a.G)};
}

/// The lecture's table, with the operators of the half-edge literature that it leaves out.
std::set<Delta> documented(OperatorKind kind)
{
    switch (kind) {
    case OperatorKind::MVFS: return {{1, 0, 1, 1, 1, 0}};
    case OperatorKind::KVFS: return {{-1, 0, -1, -1, -1, 0}};
    case OperatorKind::MEV:
    case OperatorKind::SEMV: return {{1, 1, 0, 0, 0, 0}};
    case OperatorKind::KEV:
    case OperatorKind::JEKV: return {{-1, -1, 0, 0, 0, 0}};
    case OperatorKind::MVR: return {{1, 0, 0, 1, 0, 0}};
    case OperatorKind::KVR: return {{-1, 0, 0, -1, 0, 0}};
    case OperatorKind::MEF: return {{0, 1, 1, 1, 0, 0}};
    case OperatorKind::KEF: return {{0, -1, -1, -1, 0, 0}};
    case OperatorKind::KEMR: return {{0, -1, 0, 1, 0, 0}};
    case OperatorKind::MEKR: return {{0, 1, 0, -1, 0, 0}};
    case OperatorKind::KFMRH: return {{0, 0, -1, 0, 0, 1}, {0, 0, -1, 0, -1, 0}};
    case OperatorKind::MFKRH: return {{0, 0, 1, 0, 0, -1}, {0, 0, 1, 0, 1, 0}};
    case OperatorKind::RINGMV:
    case OperatorKind::MOVE: break;
    }
    return {{0, 0, 0, 0, 0, 0}};
}

void check_sound(const Solid& solid)
{
    const auto breach = why_not_valid(solid);
    REQUIRE_MESSAGE(!breach, (breach ? sentence(*breach) : ""));
    CHECK(euler_counts(solid).formula() == 0);
}

/// Many random sound states, each with a kind of operator to try there.
void on_random_steps(const std::function<void(RandomWalk&, OperatorKind)>& take_step)
{
    for (std::uint32_t seed = 1; seed <= 60; ++seed) {
        CAPTURE(seed);
        RandomWalk walk(seed);
        for (int i = 0; i < 30 + static_cast<int>(seed); ++i) walk.step(2.0);
        std::mt19937 random(seed);
        for (int i = 0; i < 60; ++i) {
            const auto kind = static_cast<OperatorKind>(random() % n_kinds);
            CAPTURE(name(kind));
            if (walk.solid.is_empty()) walk.step();
            take_step(walk, kind);
        }
    }
}

bool attempted(RandomWalk& walk, OperatorKind kind)
{
    for (int i = 0; i < 20; ++i)
        if (walk.attempt(kind)) return true;
    return false;
}

} // namespace

TEST_SUITE("operator contract")
{
    TEST_CASE("Every operator changes the counts as the lecture's table says, and leaves the solid sound")
    {
        std::map<OperatorKind, std::set<Delta>> seen;
        on_random_steps([&](RandomWalk& walk, OperatorKind kind) {
            const EulerCounts before = euler_counts(walk.solid);
            if (!attempted(walk, kind)) return;
            check_sound(walk.solid);
            seen[kind].insert(difference(before, euler_counts(walk.solid)));
        });
        REQUIRE(seen.size() == n_kinds);
        for (const auto& entry : seen) {
            CAPTURE(name(entry.first));
            CHECK(entry.second == documented(entry.first));
        }
    }

    TEST_CASE("Undo restores every number and every link bit for bit, and redo makes them again")
    {
        on_random_steps([&](RandomWalk& walk, OperatorKind kind) {
            const Solid before = walk.solid;
            if (!attempted(walk, kind)) return;
            const Solid after = walk.solid;
            const std::size_t n_done = walk.journal.n_done();
            walk.op().undo();
            REQUIRE(walk.solid == before);
            walk.op().redo();
            REQUIRE(walk.solid == after);
            CHECK(walk.journal.n_done() == n_done);
        });
    }

    TEST_CASE("A step that follows an undo takes the place of the undone ones")
    {
        RandomWalk walk(7);
        for (int i = 0; i < 40; ++i) walk.step(2.0);
        for (int i = 0; i < 15; ++i) walk.op().undo();
        const Solid before = walk.solid;
        walk.step();
        CHECK(walk.journal.n_undone() == 0);
        CHECK(walk.journal.n_done() == 26);
        walk.op().undo();
        CHECK(walk.solid == before);
    }

    TEST_CASE("An operator that is refused throws the reason of its twin and changes nothing")
    {
        using Attempt =
            std::pair<std::function<std::optional<Refusal>(const EulerOperator&)>, std::function<void(EulerOperator&)>>;
        std::set<RefusalKind> seen;
        on_random_steps([&](RandomWalk& walk, OperatorKind) {
            const HalfEdgeId h{walk.below(walk.solid.half_edges().n_rows() + 2)};
            const HalfEdgeId i{walk.below(walk.solid.half_edges().n_rows())};
            const FaceId f{walk.below(walk.solid.faces().n_rows() + 1)}, g{walk.below(walk.solid.faces().n_rows())};
            const LoopId l{walk.below(walk.solid.loops().n_rows() + 1)};
            const VertexId v{walk.below(walk.solid.vertices().n_rows() + 1)};
            const std::vector<Attempt> attempts{
                {[=](const EulerOperator& op) { return op.why_not_mev(h, i); }, [=](auto& op) { op.mev(h, i, {}); }},
                {[=](const EulerOperator& op) { return op.why_not_kev(h); }, [=](auto& op) { op.kev(h); }},
                {[=](const EulerOperator& op) { return op.why_not_semv(h); }, [=](auto& op) { op.semv(h, {}); }},
                {[=](const EulerOperator& op) { return op.why_not_jekv(h); }, [=](auto& op) { op.jekv(h); }},
                {[=](const EulerOperator& op) { return op.why_not_mef(h, i); }, [=](auto& op) { op.mef(h, i); }},
                {[=](const EulerOperator& op) { return op.why_not_kef(h); }, [=](auto& op) { op.kef(h); }},
                {[=](const EulerOperator& op) { return op.why_not_kemr(h); }, [=](auto& op) { op.kemr(h); }},
                {[=](const EulerOperator& op) { return op.why_not_mekr(h, i); }, [=](auto& op) { op.mekr(h, i); }},
                {[=](const EulerOperator& op) { return op.why_not_kfmrh(f, g); }, [=](auto& op) { op.kfmrh(f, g); }},
                {[=](const EulerOperator& op) { return op.why_not_mfkrh(l); }, [=](auto& op) { op.mfkrh(l); }},
                {[=](const EulerOperator& op) { return op.why_not_ringmv(l, f); }, [=](auto& op) { op.ringmv(l, f); }},
                {[=](const EulerOperator& op) { return op.why_not_mvr(f); }, [=](auto& op) { op.mvr(f, {}); }},
                {[=](const EulerOperator& op) { return op.why_not_kvr(l); }, [=](auto& op) { op.kvr(l); }},
                {[=](const EulerOperator& op) { return op.why_not_kvfs(f); }, [=](auto& op) { op.kvfs(f); }},
                {[=](const EulerOperator& op) { return op.why_not_move(v); }, [=](auto& op) { op.move(v, {}); }}};
            const Attempt& attempt = attempts[walk.below(attempts.size())];
            const auto reason = attempt.first(walk.op());
            if (!reason) return;
            seen.insert(reason->kind);
            const Solid solid = walk.solid;
            const Journal journal = walk.journal;
            CHECK_THROWS_WITH_AS(attempt.second(walk.op()), sentence(*reason).c_str(), EulerError);
            CHECK(walk.solid == solid);
            CHECK(walk.journal == journal);
        });
        CHECK(seen.size() == 15);
    }
}

namespace {

/// Every entity with all that its row says, but for the anchors: which of its half-edges a vertex or loop names.
std::string links(const Solid& solid)
{
    std::string text;
    for (const HalfEdgeId h : solid.half_edges()) {
        const HalfEdge& row = solid.half_edges()[h];
        for (const std::uint32_t link : {row.start.index, row.loop.index, row.next.index, row.prev.index})
            text += std::to_string(h.index) + ":" + std::to_string(link) + " ";
    }
    for (const LoopId l : solid.loops())
        text += std::to_string(solid.face(l).index) + (solid.is_outer(l) ? "o " : "r ");
    return text;
}

} // namespace

TEST_SUITE("operator contract")
{
    TEST_CASE("The inverse operator itself takes a new edge, vertex, face or bridge away again")
    {
        on_random_steps([&](RandomWalk& walk, OperatorKind) {
            const HalfEdgeId h = [&] {
                while (true)
                    if (const HalfEdgeId id{walk.below(walk.solid.half_edges().n_rows())}; walk.solid.has(id))
                        return id;
            }();
            EulerOperator& op = walk.op();
            const std::string before = links(walk.solid);
            op.kev(op.mev(h, walk.solid.next_around_vertex(h), {1, 2, 3}).plus);
            REQUIRE(links(walk.solid) == before);
            op.kev(op.mev(h, {1, 2, 3}).plus);
            REQUIRE(links(walk.solid) == before);
            op.kef(op.mef(h, walk.solid.prev(h)).plus);
            REQUIRE(links(walk.solid) == before);
            op.kef(op.mef(h, h).plus);
            REQUIRE(links(walk.solid) == before);
            op.kvr(op.mvr(walk.solid.face(h), {1, 2, 3}).loop);
            REQUIRE(links(walk.solid) == before);
            op.kvfs(op.mvfs({1, 2, 3}).face);
            REQUIRE(links(walk.solid) == before);
            if (!op.why_not_semv(h)) op.jekv(op.semv(h, {1, 2, 3}).plus);
            REQUIRE(links(walk.solid) == before);
            const LoopId ring = op.mvr(walk.solid.face(h), {1, 2, 3}).loop;
            const std::string with_ring = links(walk.solid);
            op.kfmrh(walk.solid.face(h), op.mfkrh(ring));
            REQUIRE(links(walk.solid) == with_ring);
            op.kemr(op.mekr(h, walk.solid.half_edge(ring)).plus);
            check_sound(walk.solid);
            op.kvr(walk.solid.loops().last());
            CHECK(links(walk.solid) == before);
        });
    }
}
