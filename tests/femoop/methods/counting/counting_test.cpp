#include <doctest/doctest.h>

#include <algorithm>
#include <memory>

#include "femoop/analysis/equilibrium.h"
#include "femoop/analysis/linear_static.h"
#include "femoop/analysis/static_system.h"
#include "femoop/methods/counting/counting.h"
#include "tests/femoop/analysis/mobility.h"
#include "tests/femoop/analysis/random_structure.h"
#include "tests/femoop/methods/counting/self_stress.h"
#include "tests/frame_maker.h"
#include "tests/samples.h"

using namespace femoop;
using counting::count;
using counting::Counting;
using enum SupportKind;

namespace {

/// From the forces of members and the equations of nodes, stable or not.
Indeterminacy counted_by_nodes(const Model& model)
{
    const auto structure = std::make_shared<const Discretisation>(discretise(model));
    StaticSystem system(structure, SolverKind::Automatic);
    system.assemble();
    return count_indeterminacy(*structure, system.restraints().rotations.size());
}

void check_same(const Indeterminacy& a, const Indeterminacy& b)
{
    CHECK(a.external == b.external);
    CHECK(a.internal == b.internal);
    CHECK(a.has_foundation == b.has_foundation);
}

bool has_torsion(AnalysisKind kind) { return kind == AnalysisKind::Grillage || kind == AnalysisKind::Frame3d; }

/// By releases of its own two ends, whatever holds their nodes.
bool is_loose(const Member& member)
{
    using enum Dof;
    const auto n_released = [&](Dof dof) {
        return static_cast<int>(member.start.release.contains(dof)) +
               static_cast<int>(member.end.release.contains(dof));
    };
    return n_released(ux) > 1 || n_released(uy) > 1 || n_released(uy) + n_released(rz) > 2;
}

/// Two bays and a storey, fixed at two feet, on a roller at the third.
FrameMaker two_bays()
{
    FrameMaker made;
    made.node("A", 0, 0, Fixed)
        .node("B", 5, 0, Fixed)
        .node("C", 9, 0, Roller)
        .node("D", 0, 4)
        .node("E", 5, 4)
        .node("F", 9, 4);
    made.member("A", "D").member("B", "E").member("C", "F").member("D", "E").member("E", "F");
    return made;
}

} // namespace

TEST_CASE("Rings, releases, reactions and parts add up to what the equations of all nodes leave open")
{
    for (const AnalysisKind kind : every_model)
        for (unsigned seed = 1; seed <= 60; ++seed) {
            CAPTURE(name(kind));
            CAPTURE(seed);
            const Model model = random_structure(kind, seed);
            const Counting counting = count(model);
            check_same(counting.degree(), analyse(model).indeterminacy());
            CHECK(counting.n_motions == 0);
        }
}

TEST_CASE("A structure that can move is counted alike, and its motions too")
{
    const std::size_t n = samples(120, 30);
    std::size_t n_moving = 0;
    for (const AnalysisKind kind : every_model)
        for (unsigned seed = 1; seed <= n; ++seed) {
            CAPTURE(name(kind));
            CAPTURE(seed);
            const Model model = random_linkage(kind, seed);
            const Counting counting = count(model);
            check_same(counting.degree(), counted_by_nodes(model));
            const Mobility free = mobility(model);
            if (!free.is_clear) continue;
            const auto n_motions = static_cast<int>(counting.n_motions.value());
            CHECK(n_motions >= free.n_mechanisms);
            if (has_torsion(kind)) CHECK(n_motions <= free.n_free); // spins that supports let count too
            else CHECK(n_motions == free.n_mechanisms);
            n_moving += counting.n_motions == 0 ? 0 : 1;
        }
    CHECK(n_moving > n / 3);
}

TEST_CASE("The degree of a plane frame is its states of self-stress less its motions, loose members among them")
{
    const std::size_t n = samples(300, 100);
    std::size_t n_loose = 0;
    for (unsigned seed = 1; seed <= n; ++seed) {
        CAPTURE(seed);
        const Model model = random_linkage(AnalysisKind::Frame2d, seed);
        if (!mobility(model).is_clear) continue;
        const Counting counting = count(model);
        REQUIRE(counting.n_motions);
        CHECK(counting.degree().total() == n_self_stresses(model) - static_cast<int>(*counting.n_motions));
        n_loose += std::ranges::count_if(model.members, is_loose);
    }
    CHECK(n_loose > n / 10);
}

TEST_CASE("Each release of a member that they leave loose takes one, and the member's motion is told")
{
    struct Case {
        DofSet start, end;
        int n_released;
        std::size_t n_motions;
    };
    using enum Dof;
    for (const Case& each :
         {Case{{ux}, {ux}, 2, 1}, Case{{uy}, {uy}, 2, 1}, Case{{rz}, {rz, uy}, 3, 1}, Case{{uy, rz}, {uy, rz}, 4, 2}}) {
        CAPTURE(each.n_released);
        FrameMaker made;
        made.node("A", 0, 0, Fixed).node("B", 4, 0, Fixed).member("A", "B");
        made.model.members[0].start.release = each.start;
        made.model.members[0].end.release = each.end;
        const Counting counting = count(made.model);
        CHECK(counting.n_released() == each.n_released);
        CHECK(counting.degree().total() == 3 - each.n_released);
        CHECK(counting.n_motions == each.n_motions);
    }
}

TEST_CASE("A frame without rings is indeterminate by its supports alone")
{
    const Counting counting = count(two_bays().model);
    CHECK(counting.rings.empty());
    CHECK(counting.n_reactions() == 7);
    CHECK(counting.degree().external == 4);
    CHECK(counting.degree().internal == 0);
}

TEST_CASE("Each ring adds three, each hinge takes one less than members meet in it")
{
    FrameMaker made = two_bays();
    made.member("A", "B").member("B", "C");
    made.model.nodes[4].hinge = true; // D-E, B-E and E-F
    const Counting counting = count(made.model);
    CHECK(counting.rings.size() == 2);
    REQUIRE(counting.releases.size() == 1);
    CHECK(counting.releases[0].node == NodeId(4));
    CHECK(counting.releases[0].ends.size() == 3);
    CHECK(counting.releases[0].count() == 2);
    CHECK(counting.degree().internal == 2 * 3 - 2);
}

TEST_CASE("A hinge at a pinned foot counts nothing")
{
    FrameMaker made;
    made.node("A", 0, 0, Pin).node("B", 0, 4).node("C", 5, 4).node("D", 5, 0, Pin);
    made.member("A", "B").member("B", "C").member("C", "D");
    made.model.members[0].start.release = {Dof::rz};
    const Counting counting = count(made.model);
    REQUIRE(counting.releases.size() == 1);
    CHECK(counting.releases[0].n_free_rotations == 1);
    CHECK(counting.releases[0].count() == 0);
    CHECK(counting.degree().total() == 1);
}

TEST_CASE("A node without members counts nothing and is named")
{
    FrameMaker made = two_bays();
    made.node("X", 20, 3, Fixed);
    const Counting counting = count(made.model);
    CHECK(counting.n_joints == 6);
    CHECK(counting.n_reactions() == 7);
    REQUIRE(counting.loose_nodes.size() == 1);
    CHECK(counting.loose_nodes[0] == NodeId(6));
}

TEST_CASE("Springs count as what they hold")
{
    FrameMaker made = two_bays();
    made.model.nodes[2].support = Support{.fixed = {Dof::uy}, .springs = {{Dof::rz, 300.0}}};
    const Counting counting = count(made.model);
    CHECK(counting.reactions[2].n_blocked == 1);
    CHECK(counting.reactions[2].n_springs == 1);
    CHECK(counting.degree().total() == 5);
}

TEST_CASE("A count of zero does not keep a structure from moving")
{
    FrameMaker made; // a beam on three rollers: one restraint too many along nothing, one too few across
    made.node("A", 0, 0, Roller).node("B", 3, 0, Roller).node("C", 7, 0, Roller).member("A", "B").member("B", "C");
    const Counting counting = count(made.model);
    CHECK(counting.degree().total() == 0);
    CHECK(counting.n_motions == 1);
}

TEST_CASE("Inextensible and rigid members and offsets change no count")
{
    FrameMaker made = two_bays();
    made.member("A", "B").member("B", "C");
    const Indeterminacy plain = count(made.model).degree();
    made.model.members[3].inextensible = true;
    made.model.members[1].rigid = true;
    made.model.members[4].start.offset = {Quantity(0.3), Quantity(0.0)};
    check_same(count(made.model).degree(), plain);
}
