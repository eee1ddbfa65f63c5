// Taking parts out of a model: what stays means what it meant.
#include <doctest/doctest.h>

#include "femoop/edit/erase.h"

using namespace femoop;

namespace {

/// Three nodes in a row, two members, a load on each, two load cases and two combinations.
Model row()
{
    Model model;
    const MaterialId steel = model.add(Material{.id = "steel", .E = 210e6});
    const SectionId thin = model.add(Section{.id = "thin", .A = 0.01, .Iz = 1e-4});
    const SectionId thick = model.add(Section{.id = "thick", .A = 0.02, .Iz = 3e-4});
    const NodeId a = model.add(Node{.id = "A", .at = {0, 0}, .support = Support{.kind = SupportKind::Fixed}});
    const NodeId b = model.add(Node{.id = "B", .at = {2, 0}});
    const NodeId c = model.add(Node{.id = "C", .at = {5, 0}});
    const MemberId ab = model.add(Member{.id = "AB", .nodes = {a, b}, .material = steel, .section = thin});
    const MemberId bc = model.add(Member{.id = "BC", .nodes = {b, c}, .material = steel, .section = thick});
    const CaseId g = model.add(LoadCase{.id = "G",
                                        .nodes = {{b, {{Dof::uy, -1}}}, {c, {{Dof::uy, -2}}}},
                                        .settlements = {{a, {{Dof::uy, -0.01}}}},
                                        .members = {{ab, Misfit{0.001}}, {bc, Misfit{0.002}}}});
    const CaseId q = model.add(LoadCase{.id = "Q", .nodes = {{c, {{Dof::ux, 3}}}}});
    model.combinations.push_back({.id = "U", .terms = {{g, 1.35}, {q, 1.5}}});
    model.combinations.push_back({.id = "V", .terms = {{CaseId(2), 2.0}, {q, 0.5}}});
    model.expected = {Expected{.load_case = CaseId(3), .node = c}, Expected{.load_case = g, .member = bc},
                      Expected{.load_case = q, .member = ab}};
    return model;
}

} // namespace

TEST_SUITE("edit: erasing")
{
    TEST_CASE("A node goes with its members, its loads and the checks on them; the others keep theirs")
    {
        Model model = row();
        erase(model, {.nodes = {NodeId(0)}});
        CHECK(model.nodes.size() == 2);
        REQUIRE(model.members.size() == 1);
        CHECK(model.members[0].id == "BC");
        CHECK(model[model.members[0].nodes[1]].id == "C");
        const LoadCase& g = model.load_cases[0];
        CHECK(g.settlements.empty());
        REQUIRE(g.nodes.size() == 2);
        CHECK(model[g.nodes[1].node].id == "C");
        REQUIRE(g.members.size() == 1);
        CHECK(model[g.members[0].member].id == "BC");
        CHECK(model.expected.size() == 2);
        CHECK(model[*model.expected[0].node].id == "C");
    }

    TEST_CASE("A load case goes with the terms that name it, and combinations keep naming each other")
    {
        Model model = row();
        erase(model, {.cases = {CaseId(0)}});
        REQUIRE(model.load_cases.size() == 1);
        REQUIRE(model.combinations[0].terms.size() == 1);
        CHECK(model.case_name(model.combinations[0].terms[0].of) == "Q");
        CHECK(model.case_name(model.combinations[1].terms[0].of) == "U");
        CHECK(model.case_name(*model.expected[0].load_case) == "V");
    }

    TEST_CASE("A section in use is not erased, with its member it is")
    {
        Model model = row();
        CHECK_THROWS_AS(erase(model, {.sections = {SectionId(0)}}), std::invalid_argument);
        CHECK(model == row());
        erase(model, {.members = {MemberId(0)}, .sections = {SectionId(0)}});
        REQUIRE(model.members.size() == 1);
        CHECK(model[*model.members[0].section].id == "thick");
    }

    TEST_CASE("Erasing nothing changes nothing, and a part named twice is erased once")
    {
        Model model = row();
        erase(model, {});
        CHECK(model == row());
        erase(model, {.nodes = {NodeId(2), NodeId(2)}});
        CHECK(model.nodes.size() == 2);
    }

    TEST_CASE("A part that the model lacks is refused and changes nothing")
    {
        Model model = row();
        CHECK_THROWS_AS(erase(model, {.members = {MemberId(7)}}), std::out_of_range);
        CHECK(model == row());
    }
}
