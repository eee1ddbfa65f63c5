#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "apps/frame/document/drawing.h"
#include "apps/frame/document/solution.h"

using femoop::MemberId;
using femoop::NodeId;
using frame::Document;
using frame::Part;

TEST_SUITE("frame document: drawing")
{
    TEST_CASE("The first member of an empty document gets a material and a section")
    {
        Document document;
        document.model.units.force = femoop::ForceUnit::N;
        frame::draw_member(document, {0, 0}, {3, 1});
        REQUIRE(document.model.members.size() == 1);
        CHECK(document.model.materials[0].E == doctest::Approx(205e9));
        CHECK(document.model.sections.size() == 1);
    }

    TEST_CASE("A member is made like the last one")
    {
        Document document = frame::starting_document();
        document.model.members.back().theory = femoop::BeamTheory::Timoshenko;
        frame::draw_member(document, {6, 4}, {9, 4});
        const femoop::Member& drawn = document.model.members.back();
        CHECK(drawn.theory == femoop::BeamTheory::Timoshenko);
        CHECK(drawn.section == document.model.members[2].section);
        CHECK(frame::solve(document).results.has_value());
    }

    TEST_CASE("A place on an axis is saved as 0, on whichever side of it the pointer was")
    {
        Document document = frame::starting_document();
        frame::add_node(document, {9.0, -0.0});
        CHECK(!std::signbit(document.model.nodes.back().at[1].value()));
    }

    TEST_CASE("A line without length, but for rounding, draws nothing and adds no material either")
    {
        Document document;
        frame::draw_member(document, {1, 1}, {1, 1});
        CHECK(document == Document{});
        Document portal = frame::starting_document();
        frame::draw_member(portal, {1, 1}, {1, 1 + 1e-9});
        CHECK(portal == frame::starting_document());
    }

    TEST_CASE("Removing the node inside a beam that was cut gives the beam back")
    {
        Document document = frame::starting_document();
        const Document before = document;
        frame::add_node(document, {2, 4});
        REQUIRE(document.model.nodes.size() == 5);
        frame::remove(document, std::vector<Part>{NodeId(4)});
        CHECK(document == before);
    }

    TEST_CASE("Removing a corner removes its members and the loads on them")
    {
        Document document = frame::starting_document();
        frame::remove(document, std::vector<Part>{NodeId(1)});
        CHECK(document.model.nodes.size() == 3);
        CHECK(document.model.members.size() == 1);
        CHECK(document.model.load_cases[0].nodes.empty());
    }

    TEST_CASE("A load, a load case and a member are removed together")
    {
        Document document = frame::starting_document();
        const std::size_t n_cases = document.model.load_cases.size();
        frame::remove(document, std::vector<Part>{frame::NodeLoadPlace{0, 0}, MemberId(2), frame::NodeLoadPlace{0, 0}});
        CHECK(document.model.load_cases[0].nodes.empty());
        CHECK(document.model.members.size() == 2);
        frame::remove(document, std::vector<Part>{frame::LoadCasePlace{0}});
        CHECK(document.model.load_cases.size() == n_cases - 1);
    }

    TEST_CASE("A section in use stays")
    {
        Document document = frame::starting_document();
        const Document before = document;
        frame::remove(document, std::vector<Part>{femoop::SectionId(0)});
        CHECK(document == before);
    }

    TEST_CASE("A portal copied two times beside itself becomes a frame of three bays")
    {
        Document document = frame::starting_document();
        const femoop::Model before = document.model;
        const std::vector<Part> all{MemberId(0), MemberId(1), MemberId(2)};
        frame::copy(document, all, femoop::moved_by({6, 0, 0}), 2);
        frame::join(document, before, {.n_copies = 2});
        CHECK(document.model.nodes.size() == 8);
        CHECK(document.model.members.size() == 7);
        CHECK(frame::solve(document).results.has_value());
    }

    TEST_CASE("Copies that were joined are named after the nodes that they have, without gaps")
    {
        Document document = frame::starting_document();
        const femoop::Model before = document.model;
        const std::vector<Part> all{MemberId(0), MemberId(1), MemberId(2)};
        document.companion.dimensions = {{.nodes = {"B", "C"}}};
        frame::copy(document, all, femoop::moved_by({6, 0, 0}), 2);
        frame::join(document, before, {.n_copies = 2});
        frame::rename(document, before);
        std::vector<std::string> nodes, members;
        for (const femoop::Node& node : document.model.nodes) nodes.push_back(node.id);
        for (const femoop::Member& member : document.model.members) members.push_back(member.id);
        CHECK(nodes == std::vector<std::string>{"A", "B", "C", "D", "E", "F", "G", "H"});
        CHECK(members == std::vector<std::string>{"AB", "BC", "CD", "CE", "EF", "EG", "GH"});
        REQUIRE(document.companion.dimensions.size() == 3);
        CHECK(document.companion.dimensions[1].nodes == std::vector<std::string>{"C", "E"});
        CHECK(document.companion.dimensions[2].nodes == std::vector<std::string>{"E", "G"});
    }

    TEST_CASE("A node moved onto another joins it")
    {
        Document document = frame::starting_document();
        const femoop::Model before = document.model;
        frame::place(document, std::vector<Part>{NodeId(2)}, femoop::moved_by({0, -4, 0}));
        frame::join(document, before);
        CHECK(document.model.nodes.size() == 3);
        CHECK(document.model.members.size() == 2);
    }
}
