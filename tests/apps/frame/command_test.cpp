#include <doctest/doctest.h>

#include <stdexcept>

#include "apps/frame/document/command.h"
#include "apps/frame/document/document.h"

using femoop::Dof;
using femoop::MemberId;
using femoop::NodeId;

namespace {

constexpr NodeId A{0}, B{1};
constexpr MemberId BC{1};

} // namespace

TEST_SUITE("frame document")
{
    TEST_CASE("A fixed support with one degree of freedom freed keeps the others")
    {
        frame::Document document = frame::starting_document();
        frame::set_hold(document, A, Dof::rz, frame::Hold::Free);
        const femoop::Support& support = *document.model[A].support;
        CHECK(support.kind == femoop::SupportKind::Custom);
        CHECK(support.fixed == femoop::DofSet{Dof::ux, Dof::uy});
    }

    TEST_CASE("A support that holds nothing any more is gone, and a free node that is held gets one")
    {
        frame::Document document = frame::starting_document();
        frame::set_hold(document, B, Dof::uy, frame::Hold::Blocked);
        CHECK(document.model[B].support->fixed == femoop::DofSet{Dof::uy});
        frame::set_hold(document, B, Dof::uy, frame::Hold::Free);
        CHECK_FALSE(document.model[B].support);
    }

    TEST_CASE("With a support the checks of its reactions go, since a free node has none; other checks stay")
    {
        const auto with_checks = [] {
            frame::Document document = frame::starting_document();
            for (const NodeId node : {A, B})
                document.model.expected.push_back({.quantity = femoop::ExpectedQuantity::Reaction, .node = node});
            document.model.expected.push_back({.quantity = femoop::ExpectedQuantity::Displacement, .node = A});
            return document;
        };
        frame::Document freed = with_checks(), unheld = with_checks();
        frame::set_support(freed, A, std::nullopt);
        for (const Dof dof : {Dof::ux, Dof::uy, Dof::rz}) frame::set_hold(unheld, A, dof, frame::Hold::Free);
        for (const frame::Document& document : {freed, unheld}) {
            REQUIRE(document.model.expected.size() == 2);
            CHECK(document.model.expected[0].node == B);
            CHECK(document.model.expected[1].quantity == femoop::ExpectedQuantity::Displacement);
        }
    }

    TEST_CASE("Blocking a sprung degree of freedom takes its spring away")
    {
        frame::Document document = frame::starting_document();
        document.model.nodes[A.index].support->springs = {{Dof::rz, 4500.0}};
        document.model.nodes[A.index].support->kind = femoop::SupportKind::Custom;
        document.model.nodes[A.index].support->fixed = {Dof::ux};
        frame::set_hold(document, A, Dof::rz, frame::Hold::Blocked);
        CHECK(document.model[A].support->springs.empty());
        CHECK(document.model[A].support->fixed == femoop::DofSet{Dof::ux, Dof::rz});
    }

    TEST_CASE("Changing a keyword support to the object form holds what the keyword held")
    {
        frame::Document document = frame::starting_document();
        frame::set_support(document, A, femoop::SupportKind::Pin);
        frame::set_support(document, A, femoop::SupportKind::Custom);
        CHECK(document.model[A].support->fixed == femoop::DofSet{Dof::ux, Dof::uy});
    }

    TEST_CASE("A release takes the place of a spring on the same degree of freedom, at its own end only")
    {
        frame::Document document = frame::starting_document();
        document.model.members[BC.index].start.springs = {{Dof::rz, 800.0}};
        document.model.members[BC.index].end.springs = {{Dof::rz, 900.0}};
        frame::set_release(document, BC, frame::MemberEndName::Start, Dof::rz, frame::Switch::On);
        const femoop::Member& member = document.model[BC];
        CHECK(member.start.release == femoop::DofSet{Dof::rz});
        CHECK(member.start.springs.empty());
        CHECK(member.end.springs.size() == 1);
        frame::set_release(document, BC, frame::MemberEndName::Start, Dof::rz, frame::Switch::Off);
        CHECK(document.model[BC].start.release.is_empty());
    }

    TEST_CASE("Each trait is set alone")
    {
        using enum frame::MemberTrait;
        for (const auto trait : {Inextensible, Unshearable, Rigid, Bar}) {
            frame::Document document = frame::starting_document();
            frame::set_trait(document, BC, trait, frame::Switch::On);
            for (const auto other : {Inextensible, Unshearable, Rigid, Bar})
                CHECK(frame::has_trait(document.model[BC], other) == (other == trait));
        }
    }

    TEST_CASE("A projected load is global, and a local load is not projected")
    {
        frame::Document document = frame::starting_document();
        const frame::MemberLoadPlace place{0, 0};
        const auto load = [&] {
            return std::get<femoop::DistributedLoad>(document.model.load_cases[0].members[0].load);
        };
        frame::set_load_axes(document, place, femoop::LoadAxes::Local);
        frame::set_projected(document, place, frame::Switch::On);
        CHECK(load().axes == femoop::LoadAxes::Global);
        CHECK(load().projected);
        frame::set_load_axes(document, place, femoop::LoadAxes::Local);
        CHECK_FALSE(load().projected);
    }

    TEST_CASE("A command on a part that is not there is refused and changes nothing")
    {
        frame::Document document = frame::starting_document();
        const frame::Document before = document;
        CHECK_THROWS_AS(frame::set_support(document, NodeId(7), femoop::SupportKind::Pin), std::out_of_range);
        CHECK_THROWS_AS(frame::set_material(document, BC, femoop::MaterialId(3)), std::out_of_range);
        CHECK_THROWS_AS(frame::set_section(document, MemberId(9), femoop::SectionId(0)), std::out_of_range);
        CHECK_THROWS_AS(frame::set_load_axes(document, {0, 4}, femoop::LoadAxes::Local), std::out_of_range);
        CHECK(document == before);
    }
}
