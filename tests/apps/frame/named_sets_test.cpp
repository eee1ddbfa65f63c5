// Supports and loads under names: whoever has an equal one has the set.
#include <doctest/doctest.h>

#include <array>

#include "apps/frame/document/named_sets.h"
#include "apps/frame/session/property_commands.h"
#include "apps/frame/session/set_commands.h"

using namespace frame;
using namespace femoop;

namespace {

const Part A = NodeId(0), B = NodeId(1), D = NodeId(3), AB = MemberId(0), BC = MemberId(1), CD = MemberId(2);
const Part wind = NodeLoadPlace{0, 0}, dead = MemberLoadPlace{0, 0};

/// A portal whose feet are fixed, with 10 kN at B and 20 kN/m on BC.
Document with_base()
{
    Document document = starting_document();
    keep(document, A, "base");
    return document;
}

} // namespace

TEST_SUITE("frame: named supports and loads")
{
    TEST_CASE("A support that is kept under a name is that of every node with an equal one")
    {
        const Document document = with_base();
        CHECK(users(document, {0}) == std::vector<Part>{A, D});
        CHECK(set_of(document, D) == NamedSetPlace{0});
        CHECK_FALSE(set_of(document, B));
    }

    TEST_CASE("How a number was typed does not tell two supports apart")
    {
        Document document;
        for (const char* id : {"1", "2"}) document.model.add(Node{.id = id, .at = {0, 0, 0}});
        document.model.nodes[0].support = Support{.springs = {{Dof::rz, Quantity(4500, "4.5 MN*m/rad")}}};
        document.model.nodes[1].support = Support{.springs = {{Dof::rz, Quantity(4500)}}};
        keep(document, NodeId(0), "soft");
        CHECK(users(document, {0}).size() == 2);
    }

    TEST_CASE("A name that is taken is counted on")
    {
        Document document = with_base();
        keep(document, D, "base");
        CHECK(document.companion.sets[1].name == "base2");
    }

    TEST_CASE("A set is given to the nodes among the parts, and a load to the members")
    {
        Document document = with_base();
        const NamedSetPlace load = keep(document, dead, "floor");
        const std::array parts{B, AB, CD};
        give(document, {0}, parts, CaseId(0));
        CHECK(document.model.nodes[1].support == document.model.nodes[0].support);
        CHECK(give(document, load, parts, CaseId(0)).size() == 2);
        CHECK(users(document, load).size() == 3);
    }

    TEST_CASE("A member gets a named load once")
    {
        Document document = with_base();
        const NamedSetPlace load = keep(document, dead, "floor");
        CHECK(give(document, load, std::array{BC}, CaseId(0)).empty());
        CHECK(document.model.load_cases[0].members.size() == 1);
    }

    TEST_CASE("Forces on nodes are given in addition to those that act")
    {
        Document document = with_base();
        give(document, keep(document, wind, "wind"), std::array{B, D}, CaseId(0));
        CHECK(document.model.load_cases[0].nodes[0].components[0].value.value() == 20.0);
        CHECK(document.model.load_cases[0].nodes[1].components[0].value.value() == 10.0);
    }

    TEST_CASE("Replacing a set changes everything that has it, and nothing else")
    {
        Document document = with_base();
        document.model.nodes[1].support = Support{.kind = SupportKind::Pin};
        replace(document, {0}, B);
        CHECK(document.model.nodes[0].support->kind == SupportKind::Pin);
        CHECK(document.model.nodes[3].support->kind == SupportKind::Pin);
        CHECK_FALSE(document.model.nodes[2].support);
        CHECK_THROWS_AS(replace(document, {0}, dead), std::out_of_range);
    }

    TEST_CASE("A set that is deleted leaves its users as they are; one that is not there changes nothing")
    {
        Document document = with_base();
        const Model before = document.model;
        CHECK_THROWS_AS(erase(document, {1}), std::out_of_range);
        CHECK_THROWS_AS(give(document, {7}, std::array{A}, CaseId(0)), std::out_of_range);
        erase(document, {0});
        CHECK(document.companion.sets.empty());
        CHECK(document.model == before);
    }

    TEST_CASE("Condensing keeps one of equal sets and drops those that nobody has")
    {
        Document document = with_base();
        keep(document, D, "again");
        document.companion.sets.push_back({"nobody's", Support{.kind = SupportKind::Roller}});
        CHECK(condense_sets(document) == Condensed{.n_equal = 1, .n_unused = 1});
        REQUIRE(document.companion.sets.size() == 1);
        CHECK(document.companion.sets[0].name == "base");
    }

    TEST_CASE("Sets of another file come in the units of this one, once, and only those that its analysis takes")
    {
        Document other;
        other.model.units = {.length = LengthUnit::mm, .force = ForceUnit::N};
        DistributedLoad load;
        load.values = {{Dof::uy, Quantity(-12.0), std::nullopt}};
        other.companion.sets = {{"floor", MemberLoadValue(load)},
                                {"spring", Support{.springs = {{Dof::rz, Quantity(2.0e6)}}}},
                                {"twist", std::vector<Component>{{Dof::rz, Quantity(5.0)}}}};
        Document document = starting_document(); // kN and m
        CHECK(import_sets(document, other) == 3);
        CHECK(import_sets(document, other) == 0);
        REQUIRE(document.companion.sets.size() == 3);
        const auto& spring = std::get<Support>(document.companion.sets[0].value).springs[0];
        CHECK(spring.stiffness.value() == doctest::Approx(2.0)); // N mm/rad to kN m/rad: 1e-6
        Document truss;
        truss.model.analysis = AnalysisKind::Truss2d;
        CHECK(import_sets(truss, other) == 1); // no rotations there
        CHECK(truss.companion.sets[0].name == "floor");
    }

    TEST_CASE("A load that a member is too short for is not given to it, and the reason is told")
    {
        Document document = starting_document(); // BC is 6 m long, AB 4 m
        auto& load = std::get<DistributedLoad>(document.model.load_cases[0].members[0].load);
        load.from = Quantity(1.0);
        load.to = Quantity(5.0);
        keep(document, dead, "part");
        Session session(document);
        give(session, {0}, std::array{AB});
        CHECK(session.history().n_states() == 1);
        REQUIRE(session.notice);
        CHECK(session.notice->faults.size() == 1);
        give(session, {0}, std::array{BC}); // has it already
        CHECK(session.document() == document);
    }

    TEST_CASE("What is selected is kept, given, replaced and renamed as one step each")
    {
        Session session(starting_document());
        CHECK(why_not_keep(session, {}));
        CHECK(why_not_keep(session, std::array{B}));
        CHECK(why_not_keep(session, std::array{A, wind}));
        keep_under_name(session, std::array{A, D});
        CHECK(session.document().companion.sets[0].name == "support");
        CHECK_FALSE(rename(session, {0}, "base"));
        CHECK(rename(session, {0}, " "));
        give(session, {0}, std::array{B});
        select_users(session, {0});
        CHECK(session.selection.size() == 3);
        CHECK(session.history().n_states() == 4);
        session.undo();
        CHECK_FALSE(session.model().nodes[1].support);
    }
}
