// Cutting members out of a structure: what stays, and how it is held.
#include <doctest/doctest.h>

#include "femoop/analysis/linear_static.h"
#include "femoop/edit/excerpt.h"

using namespace femoop;

namespace {

constexpr double L = 4.0, l = 3.0, q = 12.0;

/// Three spans A, B, C, D on supports, the second loaded more than the others.
Model beam()
{
    Model model;
    const MaterialId steel = model.add(Material{.id = "steel", .E = 210e6});
    const SectionId thin = model.add(Section{.id = "thin", .A = 0.01, .Iz = 1e-4});
    const SectionId thick = model.add(Section{.id = "thick", .A = 0.02, .Iz = 3e-4});
    const Support pin{.kind = SupportKind::Pin}, roller{.kind = SupportKind::Roller};
    const NodeId a = model.add(Node{.id = "A", .at = {0, 0}, .support = pin});
    const NodeId b = model.add(Node{.id = "B", .at = {l, 0}, .support = roller});
    const NodeId c = model.add(Node{.id = "C", .at = {l + L, 0}, .support = roller});
    const NodeId d = model.add(Node{.id = "D", .at = {2.0 * l + L, 0}, .support = roller});
    model.add(Member{.id = "AB", .nodes = {a, b}, .material = steel, .section = thin});
    const MemberId bc = model.add(Member{.id = "BC", .nodes = {b, c}, .material = steel, .section = thick});
    const MemberId cd = model.add(Member{.id = "CD", .nodes = {c, d}, .material = steel, .section = thin});
    const DistributedLoad down{.values = {{.dof = Dof::uy, .start = -q, .end = {}}}};
    model.add(LoadCase{.id = "G", .nodes = {{d, {{Dof::rz, 5.0}}}}, .members = {{bc, down}, {cd, down}}});
    model.expected = {Expected{.load_case = CaseId(0), .member = bc}};
    model.extra = {{"cross", "{}"}};
    return model;
}

} // namespace

TEST_SUITE("edit: excerpts")
{
    TEST_CASE("A span that is cut out on both sides has the moments of a clamped one")
    {
        const Excerpt excerpt = excerpt_of(beam(), {MemberId(1)});
        REQUIRE(excerpt.model.members.size() == 1);
        CHECK(excerpt.model.members[0].id == "BC");
        REQUIRE(excerpt.held.size() == 2);
        CHECK(excerpt.model[excerpt.held[0]].id == "B");
        CHECK(excerpt.model[excerpt.held[1]].id == "C");
        const Curve curve = analyse(excerpt.model).at("G").curve(MemberId(0));
        CHECK(curve.value(MemberComponent::Mz, 0.0) == doctest::Approx(-q * L * L / 12.0));
        CHECK(curve.value(MemberComponent::Mz, 0.5 * L) == doctest::Approx(q * L * L / 24.0));
    }

    TEST_CASE("Where no member was left out supports and loads stay as they were")
    {
        const Excerpt excerpt = excerpt_of(beam(), {MemberId(1), MemberId(2)});
        REQUIRE(excerpt.held.size() == 1);
        CHECK(excerpt.model[excerpt.held[0]].id == "B");
        const Node& last = excerpt.model[*excerpt.model.find_node("D")];
        CHECK(last.support->kind == SupportKind::Roller);
        REQUIRE(excerpt.model.load_cases.size() == 1);
        CHECK(excerpt.model.load_cases[0].nodes.size() == 1);
        CHECK(excerpt.model.load_cases[0].members.size() == 2);
    }

    TEST_CASE("An excerpt of everything is the structure itself without what was expected of it")
    {
        Model whole = beam();
        const Excerpt excerpt = excerpt_of(whole, {MemberId(0), MemberId(1), MemberId(2)});
        whole.expected.clear();
        whole.extra.clear();
        CHECK(excerpt.held.empty());
        CHECK(excerpt.model == whole);
    }

    TEST_CASE("Materials and sections that no member of an excerpt has go")
    {
        const Excerpt excerpt = excerpt_of(beam(), {MemberId(0)});
        REQUIRE(excerpt.model.sections.size() == 1);
        CHECK(excerpt.model.sections[0].id == "thin");
    }
}
