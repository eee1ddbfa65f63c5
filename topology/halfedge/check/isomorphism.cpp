#include "topology/halfedge/check/isomorphism.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace topology {

namespace {

/// Two-way partners of entities of one kind; `nothing` of those that have none yet.
template <class Id> struct Pairing {
    std::vector<Id> of_a, of_b;

    Pairing(std::size_t n_a, std::size_t n_b) : of_a(n_a, nothing<Id>), of_b(n_b, nothing<Id>) {}
    bool has(Id a) const { return of_a[a.index] != nothing<Id>; }
    bool may(Id a, Id b) const
    {
        const bool are_free = !has(a) && of_b[b.index] == nothing<Id>;
        return are_free || of_a[a.index] == b;
    }
    void join(Id a, Id b)
    {
        of_a[a.index] = b;
        of_b[b.index] = a;
    }
};

struct Pairings {
    Pairing<HalfEdgeId> halves;
    Pairing<LoopId> loops;
    Pairing<FaceId> faces;
};

bool are_at_one_place(const Point& p, const Point& q)
{
    const double scale = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z), 1e-300});
    const auto near = [&](double a, double b) { return std::abs(a - b) <= 1e-9 * scale; };
    return near(p.x, q.x) && near(p.y, q.y) && near(p.z, q.z);
}

class Comparison {
public:
    Comparison(const Solid& a, const Solid& b, Isomorphism by) : a_(a), b_(b), by_(by) {}

    bool fits() const
    {
        return a_.counts() == b_.counts() && fits_rest({{a_.half_edges().n_rows(), b_.half_edges().n_rows()},
                                                        {a_.loops().n_rows(), b_.loops().n_rows()},
                                                        {a_.faces().n_rows(), b_.faces().n_rows()}});
    }

private:
    /// Lays the next part without partner upon each place that is left.
    bool fits_rest(const Pairings& known) const
    {
        const auto open = next_open(known);
        if (open == nothing<HalfEdgeId>) return true;
        for (const HalfEdgeId candidate : b_.half_edges()) {
            Pairings trial = known;
            if (laid(trial, open, candidate) && fits_rest(trial)) return true;
        }
        return false;
    }
    /// One in a face that has a partner, if there is any: it can lie in few places.
    HalfEdgeId next_open(const Pairings& known) const
    {
        HalfEdgeId open = nothing<HalfEdgeId>;
        for (const HalfEdgeId h : a_.half_edges()) {
            if (known.halves.has(h)) continue;
            if (known.faces.has(a_.face(h))) return h;
            if (open == nothing<HalfEdgeId>) open = h;
        }
        return open;
    }
    /// Pairs all that edges and chains connect with the two half-edges; false where they differ.
    bool laid(Pairings& pairs, HalfEdgeId a, HalfEdgeId b) const
    {
        std::vector<std::pair<HalfEdgeId, HalfEdgeId>> open{{a, b}};
        while (!open.empty()) {
            const auto [h, k] = open.back();
            open.pop_back();
            if (!pairs.halves.may(h, k)) return false;
            if (pairs.halves.has(h)) continue;
            if (!are_alike_there(pairs, h, k)) return false;
            pairs.halves.join(h, k);
            open.emplace_back(a_.next(h), b_.next(k));
            open.emplace_back(a_.mate(h), b_.mate(k));
        }
        return true;
    }
    bool are_alike_there(Pairings& pairs, HalfEdgeId h, HalfEdgeId k) const
    {
        const LoopId l = a_.loop(h), m = b_.loop(k);
        const FaceId f = a_.face(l), g = b_.face(m);
        if (a_.edge(h).has_value() != b_.edge(k).has_value() || a_.is_outer(l) != b_.is_outer(m)) return false;
        if (!pairs.loops.may(l, m) || !pairs.faces.may(f, g)) return false;
        pairs.loops.join(l, m);
        pairs.faces.join(f, g);
        return by_ == Isomorphism::Structure || are_at_one_place(a_.point(a_.start(h)), b_.point(b_.start(k)));
    }

    const Solid& a_;
    const Solid& b_;
    Isomorphism by_;
};

} // namespace

bool are_alike(const Solid& a, const Solid& b, Isomorphism by) { return Comparison(a, b, by).fits(); }

} // namespace topology
