// Cutting, merging and turning round of members: the structure stays what it was.
#include <doctest/doctest.h>

#include <algorithm>

#include "femoop/analysis/linear_static.h"
#include "femoop/edit/member_line.h"
#include "femoop/edit/merge.h"
#include "femoop/edit/reverse.h"
#include "femoop/edit/split.h"
#include "femoop/load/place_along.h"
#include "femoop/model/check/check.h"
#include "tests/femoop/analysis/random_structure.h"
#include "tests/samples.h"

using namespace femoop;

namespace {

constexpr unsigned n_seeds = samples(6, 2);

/// Every structure of beams with every member of it that is one.
template <class Claim> void for_every_beam(Claim&& claim)
{
    for (const AnalysisKind kind : {AnalysisKind::Frame2d, AnalysisKind::Grillage, AnalysisKind::Frame3d})
        for (unsigned seed = 1; seed <= n_seeds; ++seed) {
            const Model model = random_structure(kind, seed);
            const Results results = analyse(model);
            for (std::size_t i = 0; i < model.members.size(); ++i) {
                CAPTURE(name(kind));
                CAPTURE(seed);
                CAPTURE(model.members[i].id);
                claim(model, results, MemberId(i));
            }
        }
}

double largest(const CaseResult& result, const Model& model)
{
    double size = 0.0;
    for (std::size_t i = 0; i < model.nodes.size(); ++i)
        for (const double u : result.displacement(NodeId(i))) size = std::max(size, std::abs(u));
    return size;
}

/// The nodes of `before` move in `after` as they did.
void check_moves_alike(const Model& model, const CaseResult& before, const CaseResult& after)
{
    const double size = largest(before, model);
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        const NodeVector u = before.displacement(NodeId(i)), v = after.displacement(NodeId(i));
        for (std::size_t k = 0; k < n_dofs; ++k) CHECK(std::abs(u[k] - v[k]) <= 1e-6 * size);
    }
}

double largest_moment(const Curve& curve)
{
    double size = 1.0;
    for (const MemberComponent component : {MemberComponent::My, MemberComponent::Mz, MemberComponent::T}) {
        const Extremes extremes = curve.extremes(component);
        size = std::max({size, std::abs(extremes.max.value), std::abs(extremes.min.value)});
    }
    return size;
}

/// The section forces of a part are those of the whole from `begin` on.
void check_part_of(const Curve& whole, const Curve& part, double begin)
{
    const double slack = 1e-5 * largest_moment(whole);
    for (const double share : {0.13, 0.5, 0.91}) {
        const double x = share * part.length();
        const SectionForces a = whole.forces(begin + x), b = part.forces(x);
        CHECK(std::abs(a.N - b.N) <= slack);
        CHECK(std::abs(a.Vy - b.Vy) <= slack);
        CHECK(std::abs(a.Vz - b.Vz) <= slack);
        CHECK(std::abs(a.T - b.T) <= slack);
        CHECK(std::abs(a.My - b.My) <= slack);
        CHECK(std::abs(a.Mz - b.Mz) <= slack);
    }
}

/// A beam with a load of every kind.
Model loaded_beam()
{
    Model model;
    const MaterialId steel = model.add(Material{.id = "steel", .E = 210e6, .alpha = 1.2e-5, .density = 7.85});
    const SectionId deep = model.add(Section{.id = "deep", .A = 0.012, .Iz = 2.1e-4, .h = 0.4});
    const NodeId a = model.add(Node{.id = "A", .at = {0, 0}, .support = Support{.kind = SupportKind::Fixed}});
    const NodeId b = model.add(Node{.id = "B", .at = {8, 6}, .support = Support{.kind = SupportKind::Pin}});
    const MemberId beam = model.add(Member{.id = "AB", .nodes = {a, b}, .material = steel, .section = deep});
    LoadCase load_case{.id = "P", .self_weight = 1.0};
    const auto add = [&](auto load) { load_case.members.push_back({beam, load}); };
    add(DistributedLoad{.values = {{.dof = Dof::uy, .start = Quantity(-12, "-12 kN/m")}}});
    add(DistributedLoad{.values = {{.dof = Dof::uy, .start = -5, .end = -9}},
                        .from = Quantity(1.0),
                        .to = Percent{90},
                        .axes = LoadAxes::Local});
    add(PointLoad{.at = Quantity(3.0), .components = {{Dof::uy, -20}, {Dof::rz, 4}}});
    add(PointLoad{.at = Percent{70}, .components = {{Dof::ux, 7}}, .axes = LoadAxes::Local});
    add(EndLoads{.start = {{Dof::rz, 6}}, .end = {{Dof::rz, -2}}});
    add(TemperatureLoad{.top = 10, .bottom = 25});
    add(Misfit{.elongation = 0.002});
    model.add(load_case);
    return model;
}

} // namespace

TEST_SUITE("edit: cutting members")
{
    TEST_CASE("A member cut anywhere carries and moves as the whole did")
    {
        for_every_beam([](const Model& whole, const Results& results, MemberId id) {
            Model model = whole;
            const double L = line_of(model, model[id]).length, x = (0.2 + 0.07 * (id.index % 9)) * L;
            const SplitMember parts = split_member(model, id, x);
            const Results halves = analyse(model);
            for (const char* const name : {"P", "Q"}) {
                CAPTURE(name);
                check_moves_alike(whole, results.at(name), halves.at(name));
                const Curve curve = results.at(name).curve(id);
                check_part_of(curve, halves.at(name).curve(parts.first), 0.0);
                check_part_of(curve, halves.at(name).curve(parts.second), x);
            }
        });
    }

    TEST_CASE("Cut and merged again, a member carries and moves as the whole did")
    {
        for_every_beam([](const Model& whole, const Results& results, MemberId id) {
            if (whole[id].bar) return; // its parts are hinged beams
            Model model = whole;
            const SplitMember parts = split_member(model, id, 0.37 * line_of(model, model[id]).length);
            const auto obstacle = why_not_merge_at(model, parts.node);
            REQUIRE_MESSAGE(!obstacle, static_cast<int>(*obstacle));
            const MemberId merged = merge_members_at(model, parts.node);
            CHECK(model.members.size() == whole.members.size());
            const Results again = analyse(model);
            check_moves_alike(whole, results.at("P"), again.at("P"));
            check_part_of(results.at("P").curve(id), again.at("P").curve(merged), 0.0);
        });
    }

    TEST_CASE("Cut at the place of a point load, the load goes to the node")
    {
        Model model = loaded_beam();
        const SplitMember parts = split_member(model, MemberId(0), 3.0);
        REQUIRE(model.load_cases[0].nodes.size() == 1);
        CHECK(model.load_cases[0].nodes[0].node == parts.node);
        const Results whole = analyse(loaded_beam()), halves = analyse(model);
        check_moves_alike(loaded_beam(), whole.at("P"), halves.at("P"));
        check_part_of(whole.at("P").curve(MemberId(0)), halves.at("P").curve(parts.second), 3.0);
    }

    TEST_CASE("A uniform load keeps the text that was typed on both parts, and merging gives the beam back")
    {
        const Model whole = loaded_beam();
        Model model = whole;
        const SplitMember parts = split_member(model, MemberId(0), 5.0);
        CHECK(model[parts.first].id == "AC");
        CHECK(model[parts.second].id == "CB");
        std::size_t n_typed = 0;
        for (const MemberLoad& load : model.load_cases[0].members)
            if (const auto* q = std::get_if<DistributedLoad>(&load.load))
                n_typed += q->values[0].start.text() == "-12 kN/m" ? 1 : 0;
        CHECK(n_typed == 2);
        merge_members_at(model, parts.node);
        CHECK(model.members == whole.members);
        CHECK(model.nodes == whole.nodes);
        CHECK(model.load_cases[0].members.size() == whole.load_cases[0].members.size());
    }

    TEST_CASE("A part-span load that ends before the cut stays on the first part alone")
    {
        Model model = loaded_beam();
        model.load_cases[0].members = {
            {MemberId(0),
             DistributedLoad{.values = {{.dof = Dof::uy, .start = -3}}, .from = Quantity(1), .to = Quantity(2)}}};
        const Model before = model;
        split_member(model, MemberId(0), 4.0);
        CHECK(model.load_cases == before.load_cases);
    }

    TEST_CASE("A check on a member follows the place that it reads")
    {
        Model model = loaded_beam();
        const auto check = [](double at, Side side) {
            return Expected{.quantity = ExpectedQuantity::SectionForce,
                            .member = MemberId(0),
                            .component = MemberComponent::Mz,
                            .at = Quantity(at),
                            .side = side};
        };
        model.expected = {check(1.5, Side::After), check(7.0, Side::After), check(4.0, Side::Before)};
        const SplitMember parts = split_member(model, MemberId(0), 4.0);
        CHECK(model.expected[0].member == parts.first);
        CHECK(model.expected[1].member == parts.second);
        CHECK(along(*model.expected[1].at, 6.0) == doctest::Approx(3.0));
        CHECK(model.expected[2].member == parts.first);
    }

    TEST_CASE("Checks on both parts of a member follow their places into the merged one; extremes of a part go")
    {
        Model model = loaded_beam();
        const auto check = [](Position at, std::optional<Side> side) {
            return Expected{.quantity = ExpectedQuantity::SectionForce,
                            .member = MemberId(0),
                            .component = MemberComponent::Mz,
                            .at = at,
                            .side = side};
        };
        model.expected = {check(Quantity(1.5), {}), check(Quantity(7.0), Side::Before),
                          check(Percent{40.0}, Side::After)};
        const Model whole = model;
        const SplitMember parts = split_member(model, MemberId(0), 4.0);
        model.expected.push_back({.quantity = ExpectedQuantity::Extreme, .member = parts.second});
        merge_members_at(model, parts.node);
        CHECK(model.expected == whole.expected);
    }

    TEST_CASE("A place at an end or beyond is refused and changes nothing")
    {
        Model model = loaded_beam();
        for (const double x : {-1.0, 0.0, 10.0, 11.0})
            CHECK_THROWS_AS(split_member(model, MemberId(0), x), std::invalid_argument);
        CHECK(model == loaded_beam());
    }

    TEST_CASE("A member turned round leaves the nodes where they were, and its normal force is read from the other end")
    {
        for_every_beam([](const Model& before, const Results& results, MemberId id) {
            Model model = before;
            reverse_member(model, id);
            const Results turned = analyse(model);
            check_moves_alike(before, results.at("P"), turned.at("P"));
            const Curve a = results.at("P").curve(id), b = turned.at("P").curve(id);
            for (const double share : {0.2, 0.83})
                CHECK(a.forces(share * a.length()).N ==
                      doctest::Approx(b.forces((1.0 - share) * a.length()).N).epsilon(1e-5).scale(largest_moment(a)));
        });
    }

    TEST_CASE("What keeps two members from becoming one is told apart")
    {
        const auto obstacle_after = [](auto&& change) {
            Model model = loaded_beam();
            const SplitMember parts = split_member(model, MemberId(0), 5.0);
            change(model, parts);
            return why_not_merge_at(model, parts.node);
        };
        CHECK(obstacle_after([](Model&, const SplitMember&) {}) == std::nullopt);
        CHECK(obstacle_after([](Model& model, const SplitMember& parts) {
                  model.nodes[parts.node.index].support = Support{.kind = SupportKind::Roller};
              }) == MergeObstacle::Held);
        CHECK(obstacle_after([](Model& model, const SplitMember& parts) {
                  model.nodes[parts.node.index].hinge = true;
              }) == MergeObstacle::NotRigidJoint);
        CHECK(obstacle_after([](Model& model, const SplitMember& parts) {
                  model.nodes[parts.node.index].at[1] = 4.0;
              }) == MergeObstacle::NotInLine);
        CHECK(obstacle_after([](Model& model, const SplitMember& parts) {
                  model.members[parts.second.index].inextensible = true;
              }) == MergeObstacle::DifferentMembers);
        CHECK(obstacle_after([](Model& model, const SplitMember& parts) {
                  std::erase_if(model.load_cases[0].members, [&](const MemberLoad& load) {
                      return load.member == parts.second && std::holds_alternative<TemperatureLoad>(load.load);
                  });
              }) == MergeObstacle::DifferentHeating);
        CHECK(obstacle_after([](Model& model, const SplitMember& parts) {
                  model.load_cases[0].members.push_back({parts.second, EndLoads{.start = {{Dof::rz, 3}}}});
              }) == MergeObstacle::LoadedInsideJoint);
        CHECK(why_not_merge_at(loaded_beam(), NodeId(0)) == MergeObstacle::NotTwoMembers);
    }
}
