// A frame and the programs that it has handed something to, at both ends of their links.
#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <variant>

#include "apps/cross/session/session.h"
#include "apps/frame/session/linked_programs.h"
#include "apps/frame/session/other_programs.h"
#include "apps/mohr/session/session.h"
#include "tests/folder.h"
#include "ui/files/linked_copy.h"

using namespace frame;
using femoop::MemberId;

namespace {

/// A document at the other end, as `ui::DocumentApp` links it.
template <class Other> struct Taker {
    Taker(Other other, ui::Link link) : session(std::move(other)), copy(std::move(link), session.linked_text()) {}
    void tick()
    {
        copy.tick(0.6, {[this] { return session.linked_text(); },
                        [this](const std::string& text) { return session.is_news(text); }});
    }
    void adopt() { session.adopt(copy.accept()); }

    Other session;
    ui::LinkedCopy copy;
};

template <class Other> Taker<Other> started(Workspace& workspace, LinkedPrograms& linked, const Offer& offer)
{
    const auto& exported = std::get<ui::ExportToApp>(offer);
    const Folder folder;
    Other other;
    REQUIRE(other.open_copy(folder.write("handed", exported.document)));
    ui::Link link = *ui::Link::made();
    ui::Link end(link.folder());
    linked.add(std::move(link), workspace.session, exported);
    return Taker<Other>(std::move(other), std::move(end));
}

template <class Other> void exchange(Workspace& workspace, LinkedPrograms& linked, Taker<Other>& other)
{
    for (int i = 0; i < 3; ++i) {
        linked.tick(0.6, workspace);
        other.tick();
    }
}

/// Two spans of IPE 300, the first fixed and under 12 kN/m.
Workspace workspace_with_beam()
{
    using enum femoop::SupportKind;
    femoop::Model model;
    const auto steel = model.add(femoop::Material{.id = "steel", .E = 205e6, .fy = 250e3});
    const auto of = model.add(femoop::Section{.id = "S", .profile = "IPE 300"});
    const auto A = model.add(femoop::Node{.id = "A", .at = {0, 0}, .support = femoop::Support{.kind = Fixed}});
    const auto B = model.add(femoop::Node{.id = "B", .at = {7, 0}, .support = femoop::Support{.kind = Roller}});
    const auto C = model.add(femoop::Node{.id = "C", .at = {12, 0}, .support = femoop::Support{.kind = Roller}});
    const MemberId AB = model.add(femoop::Member{.id = "AB", .nodes = {A, B}, .material = steel, .section = of});
    model.add(femoop::Member{.id = "BC", .nodes = {B, C}, .material = steel, .section = of});
    const femoop::DistributedLoad down{.values = {{.dof = femoop::Dof::uy, .start = -12.0, .end = {}}}};
    model.add(femoop::LoadCase{.id = "first", .members = {{AB, down}}});
    return Workspace{Session(Document{.model = std::move(model), .companion = {}})};
}

void give_section(Workspace& workspace, const std::string& profile)
{
    workspace.session.change({ui::Message("section"), [profile](Document& document) {
                                  document.model.sections.front().profile = profile;
                                  document.model.sections.front().shape.reset();
                              }});
}

} // namespace

TEST_SUITE("frame session")
{
    TEST_CASE("The circle of a section is offered what the frame changes, and the frame its section, back and forth")
    {
        Workspace workspace = workspace_with_beam();
        workspace.session.selection = Part(MemberId(1));
        LinkedPrograms linked;
        auto other = started<mohr::Session>(workspace, linked, circle_at_section(workspace.session));
        exchange(workspace, linked, other);
        CHECK_FALSE(other.copy.offered());
        CHECK(linked.offering(workspace).empty());

        const std::string before = other.session.document().section;
        give_section(workspace, "IPE 450");
        exchange(workspace, linked, other);
        REQUIRE(other.copy.offered());
        CHECK(other.session.document().section == before); // nothing in silence
        other.adopt();
        CHECK(other.session.document().section == "IPE 450");
        exchange(workspace, linked, other);
        CHECK(linked.offering(workspace).empty()); // no echo

        CHECK_FALSE(other.session.set_number({mohr::Group::Section, 0}, "IPE 500"));
        exchange(workspace, linked, other);
        REQUIRE_FALSE(linked.offering(workspace).empty());
        const std::size_t n_steps = workspace.session.history().n_states();
        linked.adopt(workspace);
        CHECK(workspace.session.history().n_states() == n_steps + 1);
        CHECK(*workspace.session.model().sections.front().profile == "IPE 500");
        exchange(workspace, linked, other);
        CHECK(linked.offering(workspace).empty());
    }

    TEST_CASE("What the circle does with another state, or only with its fibre, is nothing that a frame is offered")
    {
        Workspace workspace = workspace_with_beam();
        workspace.session.selection = Part(MemberId(1));
        LinkedPrograms linked;
        auto other = started<mohr::Session>(workspace, linked, circle_at_section(workspace.session));
        other.session.set_number({mohr::Group::State, 3}, "0 mm");
        other.session.set_number({mohr::Group::State, 2}, "55 kN*m");
        other.session.set_subject(mohr::Subject::Rosette);
        exchange(workspace, linked, other);
        CHECK(linked.offering(workspace).empty());
    }

    TEST_CASE("What one end keeps as it is it is not asked about again, and a shape comes over with its dimensions")
    {
        Workspace workspace = workspace_with_beam();
        workspace.session.selection = Part(MemberId(1));
        LinkedPrograms linked;
        auto other = started<mohr::Session>(workspace, linked, circle_at_section(workspace.session));
        other.session.set_number({mohr::Group::State, 3}, "0 mm"); // within every section
        other.session.set_number({mohr::Group::Section, 0}, "rectangle b=90 h=210mm");
        exchange(workspace, linked, other);
        REQUIRE_FALSE(linked.offering(workspace).empty());
        linked.keep(workspace);
        exchange(workspace, linked, other);
        CHECK(linked.offering(workspace).empty());
        other.session.set_number({mohr::Group::State, 1}, "20 kN"); // a force is nothing of a section
        exchange(workspace, linked, other);
        CHECK(linked.offering(workspace).empty());
        other.session.set_number({mohr::Group::Section, 0}, "rectangle b=90 h=240mm");
        exchange(workspace, linked, other);
        linked.adopt(workspace);
        const femoop::Section& section = workspace.session.model().sections.front();
        REQUIRE(section.shape);
        CHECK(section.shape->h->value() == doctest::Approx(0.24));
        CHECK_FALSE(section.profile);
        exchange(workspace, linked, other);
        CHECK(linked.offering(workspace).empty());
        CHECK(other.session.document().section ==
              "rectangle b=90 h=240mm"); // as it was typed, though b=90mm comes back
    }

    TEST_CASE("An exercise that has the circle's state is not disturbed")
    {
        Workspace workspace = workspace_with_beam();
        workspace.session.selection = Part(MemberId(1));
        LinkedPrograms linked;
        auto other = started<mohr::Session>(workspace, linked, circle_at_section(workspace.session));
        other.session.begin_exercise(mohr::ExerciseTopic::PlaneStress, mohr::Difficulty::Easy, 1);
        give_section(workspace, "IPE 450");
        exchange(workspace, linked, other);
        const mohr::Document before = other.session.document();
        REQUIRE(other.copy.offered());
        other.adopt();
        CHECK(other.session.document() == before);
        CHECK(other.session.notice);
    }

    TEST_CASE("Moment distribution is offered another structure and gives its own back as one step")
    {
        Workspace workspace = workspace_with_beam();
        LinkedPrograms linked;
        auto other = started<cross::Session>(workspace, linked, moment_distribution(workspace.session));
        exchange(workspace, linked, other);
        CHECK_FALSE(other.copy.offered());
        CHECK(linked.offering(workspace).empty());

        give_section(workspace, "IPE 450");
        exchange(workspace, linked, other);
        REQUIRE(other.copy.offered());
        other.adopt();
        CHECK(*other.session.document().model.sections.front().profile == "IPE 450");
        exchange(workspace, linked, other);
        CHECK(linked.offering(workspace).empty());

        femoop::Model next = other.session.document().model;
        next.sections.front().profile = "HEB 200";
        other.session.change(next, ui::Message("section"));
        exchange(workspace, linked, other);
        REQUIRE_FALSE(linked.offering(workspace).empty());
        linked.adopt(workspace);
        CHECK(*workspace.session.model().sections.front().profile == "HEB 200");
        exchange(workspace, linked, other);
        CHECK(linked.offering(workspace).empty());
        CHECK_FALSE(other.copy.offered());
    }

    TEST_CASE("A structure that is taken over leaves title, notes, expected results and other programs' blocks")
    {
        Workspace workspace = workspace_with_beam();
        workspace.session.change({ui::Message("words"), [](Document& document) {
                                      document.model.title = "Bridge";
                                      document.model.notes = "of the second year";
                                      document.model.extra = {{"cross", "{}"}};
                                      document.model.expected = {{.load_case = femoop::CaseId(0),
                                                                  .node = femoop::NodeId(0),
                                                                  .dof = femoop::Dof::uy,
                                                                  .value = femoop::Quantity(0.0)}};
                                  }});
        const femoop::Model before = workspace.session.model();
        LinkedPrograms linked;
        auto other = started<cross::Session>(workspace, linked, moment_distribution(workspace.session));
        femoop::Model next = other.session.document().model;
        next.title.clear();
        next.sections.front().profile = "HEB 200";
        other.session.change(next, ui::Message("section"));
        exchange(workspace, linked, other);
        REQUIRE_FALSE(linked.offering(workspace).empty());
        linked.adopt(workspace);
        const femoop::Model& now = workspace.session.model();
        CHECK(*now.sections.front().profile == "HEB 200");
        CHECK(now.title == before.title);
        CHECK(now.notes == before.notes);
        CHECK(now.expected == before.expected);
        CHECK(now.extra == before.extra);
        exchange(workspace, linked, other);
        CHECK_FALSE(other.copy.offered());
    }

    TEST_CASE("With a support that moment distribution has taken away go the reactions that were expected of it")
    {
        Workspace workspace = workspace_with_beam();
        const auto reaction = [](std::size_t node) {
            return femoop::Expected{.quantity = femoop::ExpectedQuantity::Reaction,
                                    .load_case = femoop::CaseId(0),
                                    .node = femoop::NodeId(node),
                                    .dof = femoop::Dof::uy,
                                    .value = femoop::Quantity(5.0)};
        };
        workspace.session.change({ui::Message("words"), [&](Document& document) {
                                      document.model.expected = {reaction(2), reaction(1)};
                                  }});
        LinkedPrograms linked;
        auto other = started<cross::Session>(workspace, linked, moment_distribution(workspace.session));
        femoop::Model next = other.session.document().model;
        next.nodes[2].support.reset();
        next.expected.clear(); // as after every change by hand
        other.session.change(next, ui::Message("support"));
        exchange(workspace, linked, other);
        REQUIRE_FALSE(linked.offering(workspace).empty());
        linked.adopt(workspace);
        const femoop::Model& now = workspace.session.model();
        CHECK_FALSE(now.nodes[2].support);
        CHECK(now.expected == std::vector{reaction(1)});
        REQUIRE(workspace.session.notice);
        CHECK(workspace.session.tr()(workspace.session.notice->sentence).find("were deleted with the parts") !=
              std::string::npos);
    }

    TEST_CASE("A faulty case keeps its loads when the structure of moment distribution is taken over")
    {
        Workspace workspace = workspace_with_beam();
        workspace.session.change(
            {ui::Message("load"), [](Document& document) {
                 document.model.load_cases.push_back(
                     {.id = "gone",
                      .members = {{MemberId(1),
                                   femoop::PointLoad{.at = femoop::Quantity(80.0),
                                                     .components = {{femoop::Dof::uy, femoop::Quantity(-7.0)}}}}}});
             }});
        const auto faulty = workspace.session.model().load_cases.back();
        REQUIRE(workspace.session.solution().blank.size() == 1);
        LinkedPrograms linked;
        auto other = started<cross::Session>(workspace, linked, moment_distribution(workspace.session));
        femoop::Model next = other.session.document().model;
        next.sections.front().profile = "HEB 200";
        other.session.change(next, ui::Message("section"));
        exchange(workspace, linked, other);
        REQUIRE_FALSE(linked.offering(workspace).empty());
        linked.adopt(workspace);
        CHECK(*workspace.session.model().sections.front().profile == "HEB 200");
        CHECK(workspace.session.model().load_cases.back() == faulty);
    }

    TEST_CASE("A part of the structure is told why it is not taken back")
    {
        Workspace workspace = workspace_with_beam();
        workspace.session.selection = Part(MemberId(1));
        LinkedPrograms linked;
        auto other = started<cross::Session>(workspace, linked, moment_distribution(workspace.session));
        femoop::Model next = other.session.document().model;
        next.sections.front().profile = "HEB 200";
        other.session.change(next, ui::Message("section"));
        exchange(workspace, linked, other);
        REQUIRE_FALSE(linked.offering(workspace).empty());
        const Document before = workspace.session.document();
        linked.adopt(workspace);
        CHECK(workspace.session.document() == before);
        CHECK(workspace.session.notice);
    }
}
