// Moving, turning, mirroring, scaling and copying.
#include <doctest/doctest.h>

#include <Eigen/LU>
#include <numbers>

#include "femoop/analysis/linear_static.h"
#include "femoop/edit/member_line.h"
#include "femoop/edit/place.h"
#include "tests/frame_maker.h"

using namespace femoop;

namespace {

/// A cantilever with a load in its own axes at a length, on a roller at the tip.
Model propped()
{
    FrameMaker made({.id = "s", .A = 0.01, .Iz = 1e-4});
    made.node("A", 1, 2, SupportKind::Fixed).node("B", 6, 2, SupportKind::Roller).member("A", "B");
    made.load("AB", PointLoad{.at = Quantity(2.0), .components = {{Dof::uy, -30}}, .axes = LoadAxes::Local});
    return made.model;
}

/// Two beams at a right angle, clamped at one end and held in part at the other, under a load and a torque.
Model grillage()
{
    Model model;
    model.analysis = AnalysisKind::Grillage;
    model.add(Material{.id = "concrete", .E = 30e6});
    model.add(Section{.id = "s", .Iz = 2e-3, .J = 1.5e-3});
    const NodeId a = model.add(Node{.id = "A", .at = {0, 0}, .support = Support{.kind = SupportKind::Fixed}});
    const NodeId b = model.add(Node{.id = "B", .at = {4, 0}});
    const NodeId c = model.add(
        Node{.id = "C", .at = {4, 3}, .support = Support{.fixed = {Dof::uz, Dof::rx}, .springs = {{Dof::ry, 700.0}}}});
    const auto beam = [&](const char* id, NodeId from, NodeId to) {
        return model.add(Member{.id = id, .nodes = {from, to}, .material = MaterialId(0), .section = SectionId(0)});
    };
    const MemberId ab = beam("AB", a, b);
    beam("BC", b, c);
    const PointLoad point{.at = Quantity(1.5), .components = {{Dof::uy, -20}, {Dof::rx, 8}}, .axes = LoadAxes::Local};
    model.add(LoadCase{.id = "P", .members = {{ab, point}}});
    return model;
}

/// A column and two beams at right angles, held at the tip along y alone, with loads in members' own axes.
Model space_frame()
{
    Model model;
    model.analysis = AnalysisKind::Frame3d;
    model.add(Material{.id = "steel", .E = 210e6, .G = 81e6});
    model.add(Section{.id = "s", .A = 0.01, .Iz = 1e-4, .Iy = 3e-5, .J = 2e-5});
    const NodeId a = model.add(Node{.id = "A", .at = {1, 2, 0}, .support = Support{.kind = SupportKind::Fixed}});
    const NodeId b = model.add(Node{.id = "B", .at = {1, 2, 4}});
    const NodeId c = model.add(Node{.id = "C", .at = {6, 2, 4}});
    const NodeId d = model.add(Node{
        .id = "D", .at = {6, 5, 4}, .support = Support{.fixed = {Dof::uy, Dof::rx}, .springs = {{Dof::uz, 900.0}}}});
    const auto beam = [&](const char* id, NodeId from, NodeId to) {
        return model.add(Member{.id = id, .nodes = {from, to}, .material = MaterialId(0), .section = SectionId(0)});
    };
    const MemberId ab = beam("AB", a, b), bc = beam("BC", b, c);
    const MemberId cd = beam("CD", c, d);
    model.members[cd.index].up = {1, 0, 2};
    const auto load = [&](MemberId member, std::vector<Component> components) {
        const PointLoad point{.at = Quantity(1.5), .components = std::move(components), .axes = LoadAxes::Local};
        model.load_cases.front().members.push_back({member, point});
    };
    model.add(LoadCase{.id = "P"});
    load(ab, {{Dof::uy, -20}, {Dof::uz, 7}});
    load(bc, {{Dof::ux, 3}, {Dof::uz, 11}, {Dof::rx, 5}, {Dof::rz, -4}});
    load(cd, {{Dof::uy, 9}, {Dof::ry, 6}});
    return model;
}

const std::vector<NodeId> both{NodeId(0), NodeId(1)};

double moment_at_wall(const Model& model) { return analyse(model).at("P").curve(MemberId(0)).forces(0.0).Mz; }

} // namespace

TEST_SUITE("edit: placing")
{
    TEST_CASE("A structure turned as a whole, supports too, is stressed as before")
    {
        const double M = moment_at_wall(propped());
        for (const double angle : {0.3, 1.9, -2.4}) {
            Model model = propped();
            place_nodes(model, both, turned({4, -3, 0}, angle));
            CHECK(moment_at_wall(model) == doctest::Approx(M));
        }
    }

    TEST_CASE("A mirrored structure bends to the mirrored side")
    {
        const double M = moment_at_wall(propped());
        for (const Eigen::Vector3d& along :
             {Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(2, 3, 0)}) {
            Model model = propped();
            place_nodes(model, both, mirrored({9, 1, 0}, Eigen::Vector3d(9, 1, 0) + along));
            CHECK(moment_at_wall(model) == doctest::Approx(-M)); // the member's y' is on the other side
        }
    }

    TEST_CASE(
        "Mirroring and turning keep the direction of a load in global axes and turn one in the member's axes along")
    {
        for (const Placement& placement : {mirrored({9, 1, 0}, {9, 4, 0}), turned({4, -3, 0}, 0.7)}) {
            Model model = propped();
            const PointLoad wind{.at = Quantity(2.0), .components = {{Dof::ux, 7}, {Dof::uy, -5}}};
            model.load_cases[0].members.push_back({MemberId(0), wind});
            model.load_cases[0].nodes.push_back({NodeId(1), {{Dof::ux, 3}}});
            place_nodes(model, both, placement);
            const auto& loads = model.load_cases[0];
            CHECK(std::get<PointLoad>(loads.members[1].load).components == wind.components);
            CHECK(loads.nodes[0].components[0].value == 3.0);
            const bool is_mirrored = placement.linear().determinant() < 0.0;
            CHECK(std::get<PointLoad>(loads.members[0].load).components[0].value == (is_mirrored ? 30.0 : -30.0));
        }
    }

    TEST_CASE("A grillage turns with supports that can turn, and stays one that can be solved")
    {
        const auto deflection = [](const Model& model) {
            return analyse(model).at("P").displacement(NodeId(1))[index(Dof::uz)];
        };
        const auto twist = [](const Model& model) { return analyse(model).at("P").curve(MemberId(0)).forces(0.0).T; };
        Model model = grillage();
        const double uz = deflection(model), T = twist(model);
        const std::vector<NodeId> all{NodeId(0), NodeId(1), NodeId(2)};
        constexpr double quarter = 0.5 * std::numbers::pi;
        place_nodes(model, all, turned({1, 2, 0}, quarter));
        CHECK(model.nodes[2].support->fixed == DofSet{Dof::uz, Dof::ry});
        CHECK(model.nodes[2].support->springs[0].dof == Dof::rx);
        CHECK(deflection(model) == doctest::Approx(uz));
        place_nodes(model, all, mirrored({0, 0, 0}, {0, 3, 0}));
        CHECK(deflection(model) == doctest::Approx(uz));
        CHECK(twist(model) == doctest::Approx(-T));
        model.nodes[2].support = model.nodes[0].support; // clamped: alike in every direction
        const double clamped = deflection(model);
        place_nodes(model, all, turned({1, 2, 0}, 0.3));
        CHECK(deflection(model) == doctest::Approx(clamped));
    }

    TEST_CASE("A structure in space that is turned by quarters or mirrored moves and is stressed as before")
    {
        const Model before = space_frame();
        const CaseResult was = analyse(before).at("P");
        const std::vector<NodeId> all{NodeId(0), NodeId(1), NodeId(2), NodeId(3)};
        constexpr double quarter = 0.5 * std::numbers::pi;
        const auto moved = [](const CaseResult& result, NodeId node) {
            const NodeVector u = result.displacement(node);
            return Eigen::Vector3d(u[0], u[1], u[2]);
        };
        for (const Eigen::Index i : {0, 1, 2}) {
            const Eigen::Vector3d axis = Eigen::Vector3d::Unit(i);
            for (const Placement& placement :
                 {turned({1, 2, 3}, quarter, axis), turned({1, 2, 3}, -quarter, axis), mirrored_at({1, 2, 3}, axis)}) {
                CAPTURE(placement.linear());
                Model model = before;
                place_nodes(model, all, placement);
                const CaseResult now = analyse(model).at("P");
                for (const NodeId node : all) {
                    CAPTURE(node.index);
                    CHECK((moved(now, node) - placement.linear() * moved(was, node)).norm() < 1e-12);
                }
                for (std::size_t k = 0; k < model.members.size(); ++k) {
                    const auto forces = [&](const CaseResult& result) { return result.curve(MemberId(k)).forces(2.0); };
                    CHECK(forces(now).N == doctest::Approx(forces(was).N));
                    CHECK(forces(now).Mz == doctest::Approx(forces(was).Mz));
                    CHECK(std::abs(forces(now).My) == doctest::Approx(std::abs(forces(was).My)));
                }
            }
        }
    }

    TEST_CASE("A member of a space frame turns its y' along, and says so only where that is not the rule's")
    {
        Model model = space_frame();
        const std::vector<NodeId> all{NodeId(0), NodeId(1), NodeId(2), NodeId(3)};
        place_nodes(model, all, moved_by({2, 3, 5}));
        CHECK(model.members[0].up.empty());
        CHECK(model.members[2].up == space_frame().members[2].up);
        place_nodes(model, all, turned({0, 0, 0}, 0.5 * std::numbers::pi));
        CHECK(model.members[0].up == std::vector<Quantity>{-1, 0, 0}); // of a column y' is along y by itself
        CHECK(model.members[1].up.empty());
        CHECK(model.members[2].up == std::vector<Quantity>{0, 1, 2});
    }

    TEST_CASE("Scaling keeps a load at its share of the member")
    {
        Model model = propped();
        place_nodes(model, both, scaled({0, 0, 0}, 3.0));
        CHECK(line_of(model, model.members[0]).length == doctest::Approx(15.0));
        CHECK(std::get<Quantity>(std::get<PointLoad>(model.load_cases[0].members[0].load).at) == doctest::Approx(6.0));
    }

    TEST_CASE("A node dragged in takes a load along that would fall off, and no other")
    {
        Model model = propped();
        place_nodes(model, std::vector{NodeId(1)}, moved_by({-1, 0, 0}));
        const auto at = [&] { return std::get<Quantity>(std::get<PointLoad>(model.load_cases[0].members[0].load).at); };
        CHECK(at() == 2.0);
        place_nodes(model, std::vector{NodeId(1)}, moved_by({-2.5, 0, 0}));
        CHECK(at() == doctest::Approx(1.5));
    }

    TEST_CASE("A support turns only where its whole surroundings do")
    {
        Model model = propped();
        place_nodes(model, std::vector{NodeId(1)}, turned({1, 2, 0}, 0.5));
        CHECK(model.nodes[1].support->kind == SupportKind::Roller);
    }

    TEST_CASE("A coordinate that does not change keeps the text that was typed")
    {
        Model model = propped();
        model.nodes[1].at[1] = Quantity(2.0, "200 cm");
        place_nodes(model, both, moved_by({3, 0, 0}));
        CHECK(model.nodes[1].at[1].text() == "200 cm");
        CHECK(model.nodes[1].at[0] == 9.0);
    }

    TEST_CASE("A copy brings its nodes, supports and loads, and leaves the original alone")
    {
        Model model = propped();
        const Parts copies = copy_parts(model, {.members = {MemberId(0)}}, moved_by({0, 4, 0}));
        REQUIRE(copies.members.size() == 1);
        CHECK(model[copies.members[0]].id == "CD");
        CHECK(model.nodes[2].support == model.nodes[0].support);
        REQUIRE(model.load_cases[0].members.size() == 2);
        CHECK(model.load_cases[0].members[1].member == copies.members[0]);
        CHECK(model.nodes[3].at[1] == 6.0);
        const CaseResult result = analyse(model).at("P");
        CHECK(result.curve(copies.members[0]).forces(0.0).Mz ==
              doctest::Approx(result.curve(MemberId(0)).forces(0.0).Mz));
    }
}
