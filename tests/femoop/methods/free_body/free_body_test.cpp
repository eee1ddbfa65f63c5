#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "femoop/analysis/linear_static.h"
#include "femoop/methods/free_body/free_body.h"
#include "tests/femoop/analysis/random_structure.h"
#include "tests/frame_maker.h"
#include "tests/samples.h"

using namespace femoop;
using namespace femoop::free_body;
using Eigen::Vector3d;
using enum SupportKind;

namespace {

constexpr double L = 5.0, q = 12.0, P = 30.0;

/// A cantilever from A under a uniform load and a force at 3 m.
Model cantilever()
{
    FrameMaker made;
    made.node("A", 0, 0, Fixed).node("B", L, 0).member("A", "B").uniform("AB", -q).point("AB", 3.0, -P);
    return made.model;
}

const Force& only(const FreeBody& body, ForceKind kind)
{
    const auto is_it = [&](const Force& force) { return force.kind == kind; };
    REQUIRE(std::ranges::count_if(body.forces, is_it) == 1);
    return *std::ranges::find_if(body.forces, is_it);
}

/// A body of a structure, thrown: a node, some members, or what lies beside some cuts.
Body thrown(const Discretisation& structure, std::mt19937& random)
{
    const auto below = [&](std::size_t n) { return random() % n; };
    const auto share = [&] { return static_cast<double>(below(101)) / 100.0; };
    if (below(3) == 0) return body_of(NodeId(below(structure.positions.size())));
    std::vector<MemberId> members;
    for (std::size_t i = 0; i < structure.members.size(); ++i)
        if (below(2) == 0) members.emplace_back(i);
    if (below(2) == 0) return body_of(structure, members);
    std::vector<Cut> cuts;
    for (const MemberId member : members) cuts.push_back({member, share() * structure.geometry(member).length});
    const std::vector<NodeId> beside{NodeId(below(structure.positions.size()))};
    return body_of(structure, cuts, beside);
}

} // namespace

TEST_CASE("The forces on every body of every structure are in equilibrium")
{
    std::mt19937 random(7);
    for (const AnalysisKind kind : every_model)
        for (unsigned seed = 1; seed <= samples(25, 5); ++seed) {
            const Model model = random_structure(kind, seed);
            const Results results = analyse(model);
            const Discretisation structure = discretise(model);
            for (int i = 0; i < 20; ++i) {
                CAPTURE(name(kind));
                CAPTURE(seed);
                CAPTURE(i);
                const Vector3d about(0.7 * i, -0.4 * i, is_3d(kind) ? 0.3 * i : 0.0);
                const CaseId load_case(random() % model.n_cases());
                const FreeBody body = lift_out(model, results, load_case, thrown(structure, random));
                const Magnitudes magnitudes = results[load_case].magnitudes();
                double size = std::max(magnitudes.force, magnitudes.moment); // rounding is the whole structure's
                const std::vector<Equation> all = equations(body, kind, about);
                for (const Equation& equation : all) size = std::max(size, equation.size);
                for (const Equation& equation : all) {
                    CAPTURE(static_cast<int>(equation.dof));
                    CHECK(std::abs(equation.sum) <= 1e-9 * size);
                }
            }
        }
}

TEST_CASE("The part of a cantilever beyond a cut has its loads and the section forces of the cut")
{
    const Model model = cantilever();
    const Results results = analyse(model);
    const std::vector<Cut> cuts{{MemberId(0), 2.0}};
    const std::vector<NodeId> beside{NodeId(1)};
    const FreeBody part = lift_out(model, results, CaseId(0), body_of(discretise(model), cuts, beside));
    const Force& cut = only(part, ForceKind::SectionForces);
    CHECK(cut.at.isApprox(Vector3d(2.0, 0.0, 0.0)));
    CHECK_FALSE(cut.is_on_plus_face);
    CHECK(cut.force.isApprox(Vector3d(0.0, 3.0 * q + P, 0.0)));
    CHECK(cut.moment.z() == doctest::Approx(4.5 * q + 1.0 * P));
    const std::vector<Equation> sums = equations(part, model.analysis, cut.at);
    REQUIRE(sums.size() == 3);
    CHECK(sums[2].dof == Dof::rz);
    CHECK(std::abs(sums[2].sum) < 1e-9);
}

TEST_CASE("What is distributed acts as its resultant where the area of the load has its centroid")
{
    FrameMaker made;
    made.node("A", 0, 0, Fixed).node("B", L, 0).member("A", "B");
    made.load("AB", DistributedLoad{.values = {{.dof = Dof::uy, .start = 0.0, .end = -q}}});
    const std::vector<MemberId> members{MemberId(0)};
    const FreeBody body = lift_out(made.model, analyse(made.model), CaseId(0),
                                   body_of(discretise(made.model), members));
    const Force& load = only(body, ForceKind::MemberLoad);
    CHECK(load.x == doctest::Approx(2.0 * L / 3.0));
    CHECK(load.force.isApprox(Vector3d(0.0, -0.5 * q * L, 0.0)));
}

TEST_CASE("Wind on a slope is one resultant beyond whatever cut, with no part along what it does not push")
{
    FrameMaker made;
    made.node("A", 0, 0, Fixed).node("B", 4.1, 2.7).member("A", "B");
    made.load("AB", DistributedLoad{.values = {{.dof = Dof::ux, .start = 2.5}}});
    const double length = std::hypot(4.1, 2.7);
    const Results results = analyse(made.model);
    for (int i = 1; i < 200; ++i) {
        const Cut cut{MemberId(0), length * std::fmod(0.7548776662466927 * i, 1.0)};
        const Body beyond = body_of(discretise(made.model), std::vector{cut}, std::vector{NodeId(1)});
        const FreeBody lifted = lift_out(made.model, results, CaseId(0), beyond);
        const Force& wind = only(lifted, ForceKind::MemberLoad);
        CHECK(wind.force.x() == doctest::Approx(2.5 * (length - cut.x)));
        CHECK(std::abs(wind.force.y()) <= 1e-12 * 2.5 * length);
    }
}

TEST_CASE("A node has the opposite of what its members have at their ends, its load and its reaction")
{
    FrameMaker made;
    made.node("A", 0, 0, Pin).node("B", 3, 0).node("C", 7, 0, Roller).member("A", "B").member("B", "C");
    made.force("B", Dof::uy, -P);
    const Results results = analyse(made.model);
    const FreeBody at_load = lift_out(made.model, results, CaseId(0), body_of(NodeId(1)));
    CHECK(only(at_load, ForceKind::NodeLoad).force.isApprox(Vector3d(0.0, -P, 0.0)));
    CHECK(std::ranges::count(at_load.forces, ForceKind::SectionForces, &Force::kind) == 2);
    const FreeBody at_support = lift_out(made.model, results, CaseId(0), body_of(NodeId(0)));
    CHECK(only(at_support, ForceKind::Reaction).force.y() == doctest::Approx(P * 4.0 / 7.0));
    CHECK(only(at_support, ForceKind::SectionForces).force.y() == doctest::Approx(-P * 4.0 / 7.0));
}

TEST_CASE("Chosen members take the nodes along that join them")
{
    FrameMaker made;
    made.node("A", 0, 0, Fixed).node("B", 0, 4).node("C", 5, 4).node("D", 5, 0, Fixed);
    made.member("A", "B").member("B", "C").member("C", "D");
    const std::vector<MemberId> members{MemberId(0), MemberId(1)};
    const Body body = body_of(discretise(made.model), members);
    REQUIRE(body.nodes.size() == 1);
    CHECK(body.nodes[0] == NodeId(1));
}

TEST_CASE("A cut through one leg of a ring leaves both of its sides in the body")
{
    FrameMaker made;
    made.node("A", 0, 0, Fixed).node("B", 5, 0).node("C", 5, 4).node("D", 0, 4);
    made.member("A", "B").member("B", "C").member("C", "D").member("D", "A");
    const std::vector<Cut> cuts{{MemberId(2), 2.0}};
    const std::vector<NodeId> beside{NodeId(0)};
    const Body body = body_of(discretise(made.model), cuts, beside);
    CHECK(body.nodes.size() == 4);
    CHECK(body.pieces.size() == 5);
}

TEST_CASE("Cuts that part nothing leave the shortest way across them; those through both legs of a ring leave none")
{
    FrameMaker made;
    made.node("A", 0, 0, Fixed).node("B", 5, 0).node("C", 5, 4).node("D", 0, 4);
    made.member("A", "B").member("B", "C").member("C", "D").member("D", "A").member("A", "C");
    const auto across = [&](std::vector<Cut> cuts) { return members_across(discretise(made.model), cuts); };
    CHECK(across({{MemberId(2), 2.0}}) == std::vector{MemberId(4), MemberId(3)}); // C to D over A
    CHECK(across({{MemberId(2), 2.0}, {MemberId(4), 1.0}}) == std::vector{MemberId(0), MemberId(1)});
    CHECK(across({{MemberId(2), 2.0}, {MemberId(3), 1.0}}).empty());
    CHECK(across({{MemberId(2), 1.0}, {MemberId(2), 2.0}}).empty()); // the middle comes off
}
