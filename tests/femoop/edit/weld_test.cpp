// Mending what drawing and moving leave behind.
#include <doctest/doctest.h>

#include "femoop/edit/place.h"
#include "femoop/edit/weld.h"
#include "femoop/model/check/check.h"

using namespace femoop;

namespace {

Member between(const char* id, std::size_t a, std::size_t b)
{
    return {.id = id, .nodes = {NodeId(a), NodeId(b)}, .material = MaterialId(0), .section = SectionId(0)};
}

Model with_nodes(std::initializer_list<std::array<double, 2>> places)
{
    Model model;
    model.add(Material{.id = "steel", .E = 210e6});
    model.add(Section{.id = "s", .A = 0.01, .Iz = 1e-4});
    for (const auto& [x, y] : places)
        model.add(Node{.id = std::string(1, static_cast<char>('A' + model.nodes.size())), .at = {x, y}});
    return model;
}

} // namespace

TEST_SUITE("edit: welding")
{
    TEST_CASE("A node dropped on another becomes one with it; support and loads of both stay")
    {
        Model model = with_nodes({{0, 0}, {4, 0}, {4, 0}, {4, 3}});
        model.add(between("AB", 0, 1));
        model.add(between("CD", 2, 3));
        model.nodes[2].support = Support{.kind = SupportKind::Pin};
        model.add(LoadCase{.id = "P", .nodes = {{NodeId(1), {{Dof::uy, -2}}}, {NodeId(2), {{Dof::uy, -3}}}}});
        weld(model);
        REQUIRE(model.nodes.size() == 3);
        CHECK(model.nodes[1].support.has_value());
        CHECK(model.members[1].nodes[0] == NodeId(1));
        for (const NodeLoad& load : model.load_cases[0].nodes) CHECK(load.node == NodeId(1));
    }

    TEST_CASE("Of two members between the same nodes one remains, with the loads of both")
    {
        Model model = with_nodes({{0, 0}, {5, 0}});
        model.add(between("AB", 0, 1));
        model.add(between("twin", 1, 0));
        const auto at = [](double x, double f) {
            return PointLoad{.at = Quantity(x), .components = {{Dof::uy, f}}, .axes = LoadAxes::Local};
        };
        model.add(LoadCase{.id = "P", .members = {{MemberId(0), at(1, -7)}, {MemberId(1), at(1, 9)}}});
        weld(model);
        REQUIRE(model.members.size() == 1);
        const auto& turned = std::get<PointLoad>(model.load_cases[0].members[1].load);
        CHECK(std::get<Quantity>(turned.at) == 4.0);
        CHECK(turned.components[0].value == -9.0);
    }

    TEST_CASE("A member whose ends became one node goes")
    {
        Model model = with_nodes({{0, 0}, {5, 0}, {5, 0}});
        model.add(between("AB", 0, 1));
        model.add(between("BC", 1, 2));
        weld(model);
        CHECK(model.members.size() == 1);
        CHECK(model.nodes.size() == 2);
    }

    TEST_CASE("A node on a member cuts it")
    {
        Model model = with_nodes({{0, 0}, {6, 0}, {2, 0}});
        model.add(between("AB", 0, 1));
        weld(model);
        CHECK(model.members.size() == 2);
    }

    TEST_CASE("A bay copied beside itself shares the column")
    {
        Model model = with_nodes({{0, 0}, {0, 3}, {5, 3}, {5, 0}});
        model.add(between("AB", 0, 1));
        model.add(between("BC", 1, 2));
        model.add(between("CD", 2, 3));
        copy_parts(model, {.members = {MemberId(0), MemberId(1), MemberId(2)}}, moved_by({5, 0, 0}));
        weld(model);
        CHECK(model.nodes.size() == 6);
        CHECK(model.members.size() == 5);
    }

    // B o   o D        B o   o D
    //   |    /           | /         E is where they cross; X bracing has no node there.
    // A o   o C        A /   C
    TEST_CASE("A member that is moved across another is cut with it, and loads stay in place")
    {
        Model model = with_nodes({{0, 0}, {0, 4}, {1, 1}, {7, 1}});
        model.add(between("AB", 0, 1));
        model.add(between("CD", 2, 3));
        const PointLoad load{.at = Quantity(5), .components = {{Dof::uy, -7}}, .axes = LoadAxes::Global};
        model.add(LoadCase{.id = "P", .members = {{MemberId(1), load}}});
        const Model before = model;
        place_nodes(model, std::vector{NodeId(2), NodeId(3)}, moved_by({-3, 0, 0}));
        weld(model, before);
        REQUIRE(model.nodes.size() == 5);
        CHECK(position_of(model, NodeId(4)) == Eigen::Vector3d(0, 1, 0));
        CHECK(model.members.size() == 4);
        const MemberLoad& carried = model.load_cases[0].members[0];
        CHECK(model[carried.member].nodes == std::array{NodeId(4), NodeId(3)});
        CHECK(std::get<Quantity>(std::get<PointLoad>(carried.load).at) == 3.0);
    }

    TEST_CASE("Members that are to pass each other stay whole, and pass each other wherever they are moved then")
    {
        Model model = with_nodes({{0, 0}, {0, 4}, {1, 1}, {7, 1}});
        model.add(between("AB", 0, 1));
        model.add(between("CD", 2, 3));
        Model before = model;
        place_nodes(model, std::vector{NodeId(2)}, moved_by({-3, 0, 0}));
        weld(model, before, {.crossings = Crossings::Keep});
        CHECK(model.members.size() == 2);
        before = model;
        place_nodes(model, std::vector{NodeId(2)}, moved_by({0, 1, 0}));
        weld(model, before);
        CHECK(model.members.size() == 2);
    }

    TEST_CASE("What was not touched is left as it was opened: crossings, doubled nodes, members over nodes and twins")
    {
        Model model = with_nodes({{0, 0}, {4, 3}, {0, 3}, {4, 0}, {0, 0}, {2, 3}, {8, 0}, {9, 2}});
        model.add(between("AB", 0, 1));
        model.add(between("CD", 2, 3));
        model.add(between("CB", 2, 1));
        model.add(between("twin", 1, 2));
        model.add(between("GH", 6, 7));
        const Model before = model;
        place_nodes(model, std::vector{NodeId(7)}, moved_by({1, 0, 0}));
        Model moved = model;
        weld(moved, before);
        CHECK(moved == model);
    }

    TEST_CASE("Each copy of an X bracing passes itself, and is cut where it crosses another copy")
    {
        Model model = with_nodes({{0, 0}, {4, 3}, {0, 3}, {4, 0}});
        model.add(between("AB", 0, 1));
        model.add(between("CD", 2, 3));
        const Model before = model;
        const Parts bracing{.members = {MemberId(0), MemberId(1)}};
        Model beside = model;
        copy_parts(beside, copy_parts(beside, bracing, moved_by({10, 0, 0})), moved_by({10, 0, 0}));
        weld(beside, before, {.n_copies = 2});
        CHECK(beside.members.size() == 6);
        Model over = model; // either diagonal of the second copy crosses the other one of the first
        copy_parts(over, copy_parts(over, bracing, moved_by({10, 0, 0})), moved_by({2, 0, 0}));
        weld(over, before, {.n_copies = 2});
        CHECK(over.members.size() == 10);
    }

    TEST_CASE("What lands on a diagonal of an X bracing becomes one with it and cuts nothing")
    {
        Model model = with_nodes({{0, 0}, {4, 3}, {0, 3}, {4, 0}, {9, 0}, {13, 3}});
        model.add(between("AB", 0, 1));
        model.add(between("CD", 2, 3));
        model.add(between("EF", 4, 5));
        const Model before = model;
        Model mirrored = model;
        copy_parts(mirrored, {.members = {MemberId(0), MemberId(1)}},
                   femoop::mirrored(Eigen::Vector3d(2, 0, 0), Eigen::Vector3d(2, 1, 0)));
        weld(mirrored, before);
        CHECK(mirrored == model);
        place_nodes(model, std::vector{NodeId(4), NodeId(5)}, moved_by({-9, 0, 0}));
        weld(model, before);
        CHECK(model.members.size() == 2);
        CHECK(model.nodes.size() == 4);
    }

    TEST_CASE("A sound model stays bit for bit")
    {
        Model model = with_nodes({{0, 0}, {6, 0}, {2, 4}});
        model.add(between("AB", 0, 1));
        model.add(between("BC", 1, 2));
        const Model before = model;
        weld(model);
        CHECK(model == before);
    }
}
