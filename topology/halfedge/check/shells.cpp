#include "topology/halfedge/check/shells.h"

#include <algorithm>
#include <utility>

namespace topology {

namespace {

/// Which shell each face lies in, by flooding from each face that was not reached yet.
class Flood {
public:
    explicit Flood(const Solid& solid) : solid_(solid), shell_(solid.faces().n_rows(), none)
    {
        for (const FaceId f : solid.faces())
            if (shell_[f.index] == none) fill(f);
    }

    std::size_t n_shells() const { return n_shells_; }
    std::uint32_t shell(FaceId f) const { return shell_[f.index]; }

private:
    static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

    void fill(FaceId seed)
    {
        meet(seed);
        while (!open_.empty()) {
            const FaceId f = open_.back();
            open_.pop_back();
            const Tables& t = solid_.tables();
            LoopId l = solid_.outer(f);
            do {
                cross(t, l);
                l = t.loops[l].next;
            } while (l != solid_.outer(f));
        }
        ++n_shells_;
    }
    void cross(const Tables& t, LoopId l)
    {
        const HalfEdgeId first = t.loops[l].half_edge;
        HalfEdgeId h = first;
        do {
            meet(t.face(t.mate(h)));
            h = t.next(h);
        } while (h != first);
    }
    void meet(FaceId f)
    {
        if (shell_[f.index] != none) return;
        shell_[f.index] = n_shells_;
        open_.push_back(f);
    }

    const Solid& solid_;
    std::vector<std::uint32_t> shell_;
    std::vector<FaceId> open_;
    std::uint32_t n_shells_ = 0;
};

/// V - E + F - (L - F) of one shell is 2 (1 - genus).
std::size_t genus(const Counts& counts)
{
    const std::size_t removed = counts.edges + counts.loops + 2; // V + 2F is never more
    return (removed - counts.vertices - 2 * counts.faces) / 2;
}

} // namespace

std::vector<Shell> shells(const Solid& solid)
{
    const Flood flood(solid);
    std::vector<Shell> found(flood.n_shells());
    const auto counts = [&](FaceId f) -> Counts& { return found[flood.shell(f)].counts; };
    for (const FaceId f : solid.faces()) {
        found[flood.shell(f)].faces.push_back(f);
        ++counts(f).faces;
    }
    for (const LoopId l : solid.loops()) ++counts(solid.face(l)).loops;
    for (const HalfEdgeId h : solid.half_edges()) ++counts(solid.face(h)).half_edges;
    for (const EdgeId e : solid.edges()) ++counts(solid.face(solid.plus(e))).edges;
    for (const VertexId v : solid.vertices()) ++counts(solid.face(solid.half_edge(v))).vertices;
    for (Shell& shell : found) shell.genus = genus(shell.counts);
    return found;
}

long EulerCounts::formula() const
{
    const auto number = [](std::size_t n) { return static_cast<long>(n); };
    return number(V) - number(E) + number(F) - (number(L) - number(F)) - 2 * (number(S) - number(G));
}

EulerCounts euler_counts(const Solid& solid)
{
    const Counts counts = solid.counts();
    EulerCounts sum{.V = counts.vertices, .E = counts.edges, .F = counts.faces, .L = counts.loops};
    for (const Shell& shell : shells(solid)) {
        ++sum.S;
        sum.G += shell.genus;
    }
    return sum;
}

} // namespace topology
