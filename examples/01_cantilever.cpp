// How far does a cantilever's tip sag, and what holds it at the wall?
//
//      wall |=========================o tip        steel HEA 300, E = 210 GPa
//         A |            3 m          | B
//                                     v 50 kN
//
// Run       build/release/examples/01_cantilever, after ./test
// Expected  the tip sags P L^3 / (3 E I), the wall answers P upward and P L, which stretches the top fibre:
//           50 * 27 / (3 * 210e6 * 18260e-8) m = 11.74 mm, 50 kN, -150 kN m
// Source    any book on the strength of materials; I of EN 10365
// Before    nothing: this is the first
//
// Prints
//   tip sags 11.74 mm
//   wall holds 50 kN
//   moment at the wall -150 kN m
#include <cstdio>

#include "femoop/analysis/linear_static.h"

using namespace femoop;

int main()
{
    Model beam; // a plane frame; bare numbers are in kN and m
    const MaterialId steel = beam.add(Material{.id = "steel", .E = 210e6});
    const SectionId hea300 = beam.add(Section{.id = "HEA 300", .profile = "HEA 300"});
    const NodeId wall = beam.add(Node{.id = "A", .at = {0, 0}, .support = Support{.kind = SupportKind::Fixed}});
    const NodeId tip = beam.add(Node{.id = "B", .at = {3, 0}});
    const MemberId AB = beam.add(Member{.id = "AB", .nodes = {wall, tip}, .material = steel, .section = hea300});
    beam.add(LoadCase{.id = "P", .nodes = {{.node = tip, .components = {{Dof::uy, -50.0}}}}});

    const CaseResult result = analyse(beam).at("P");
    std::printf("tip sags %.2f mm\n", -1000.0 * result.displacement(tip)[index(Dof::uy)]);
    std::printf("wall holds %.0f kN\n", result.reaction(wall)[index(Dof::uy)]);
    std::printf("moment at the wall %.0f kN m\n", result.curve(AB).forces(0.0).Mz);
}
