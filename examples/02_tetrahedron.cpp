// How does a solid grow out of nothing, one Euler operator at a time, and does it go back the same way?
//
//            d                 MVFS   a point a on a sphere of one face
//           /|\                MEV    three edges, each with a new vertex: a-b, a-c, c-d
//          / | \               MEF    three edges that close a face each: b-c, b-d, a-d
//         a--+--c
//          \ | /               after every one V - E + F - (L - F) - 2 (S - G) = 0
//           \|/
//            b
//
// Run       build/release/examples/02_tetrahedron, after ./test
// Expected  4 vertices, 6 edges, 4 faces; the volume is a third of the base times the height: 6 * 4 / 3 = 8
// Source    M. Mantyla, An Introduction to Solid Modeling, chapter 9
// Before    01_cantilever.cpp shows how a program is built on the libraries
//
// Prints
//   MVFS  V 1 E 0 F 1  sum 0
//   MEV   V 2 E 1 F 1  sum 0
//   MEV   V 3 E 2 F 1  sum 0
//   MEF   V 3 E 3 F 2  sum 0
//   MEV   V 4 E 4 F 2  sum 0
//   MEF   V 4 E 5 F 3  sum 0
//   MEF   V 4 E 6 F 4  sum 0
//   volume 8
//   MEF is refused:
//   one half-edge lies in loop l2 and the other in loop l1; an operator for two loops is MEKR, for two faces KEF
//   undone: V 0 E 0 F 0
#include <cstdio>

#include "topology/halfedge/check/shells.h"
#include "topology/halfedge/operators/euler_operator.h"
#include "topology/modeling/mass_properties.h"

using namespace topology;

namespace {

void print(const char* name, const Solid& solid)
{
    const EulerCounts n = euler_counts(solid);
    std::printf("%-5s V %zu E %zu F %zu  sum %ld\n", name, n.V, n.E, n.F, n.formula());
}

} // namespace

int main()
{
    Solid solid;
    Journal journal;
    EulerOperator op(solid, journal);

    // 1. The base: two struts, and the edge that closes the triangle. It splits the one face in two.
    const LoneVertex a = op.mvfs({0, 0, 0});
    print("MVFS", solid);
    const NewEdge ab = op.mev(a.half_edge, {0, 3, 0});
    print("MEV", solid);
    const NewEdge bc = op.mev(ab.plus, {4, 0, 0});
    print("MEV", solid);
    const NewFace ac = op.mef(ab.minus, bc.plus);
    print("MEF", solid);

    // 2. A strut to the top; each further edge to the top cuts a side off the outer face.
    const NewEdge cd = op.mev(bc.plus, {0, 0, 4});
    print("MEV", solid);
    const NewFace db = op.mef(cd.plus, ab.plus);
    print("MEF", solid);
    op.mef(ac.plus, db.plus);
    print("MEF", solid);
    std::printf("volume %g\n", mass_properties(solid).volume);

    // 3. What cannot be done is refused with the reason, and changes nothing.
    try {
        op.mef(ab.minus, ab.plus);
    } catch (const EulerError& refused) {
        std::printf("MEF is refused:\n%s\n", refused.what());
    }

    // 4. The journal takes every step back by its inverse: KEF, KEF, KEV, KEF, KEV, KEV, KVFS.
    while (journal.n_done() > 0) op.undo();
    const EulerCounts n = euler_counts(solid);
    std::printf("undone: V %zu E %zu F %zu\n", n.V, n.E, n.F);
}
