// What the other programs of the suite get: members for moment distribution, a section for Mohr's circle.
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <variant>

#include "apps/cross/document/file.h"
#include "apps/cross/document/solution.h"
#include "apps/frame/session/other_programs.h"
#include "apps/mohr/document/file.h"
#include "apps/mohr/document/solution.h"
#include "tests/frame_maker.h"

using namespace frame;
using femoop::Dof;
using femoop::MemberId;
using femoop::NodeId;

namespace {

constexpr double L = 4.0, l = 3.0, q = 12.0, b = 0.09, h = 0.21; // kN, m

femoop::Section rectangle()
{
    femoop::SectionShape shape;
    shape.b = b;
    shape.h = h;
    return {.id = "R", .shape = shape};
}

/// Its centroid is 267.307692 mm above its foot.
femoop::Section tee()
{
    femoop::SectionShape shape;
    shape.kind = femoop::SectionShapeKind::T;
    shape.h = 0.4;
    shape.bf = 0.3;
    shape.tf = 0.05;
    shape.tw = 0.05;
    return {.id = "T", .shape = shape};
}

femoop::MemberLoad down_on(MemberId member)
{
    return {member, femoop::DistributedLoad{.values = {{.dof = Dof::uy, .start = -q, .end = {}}}}};
}

/// Two spans of which the first is fixed; the second case loads the second span alone.
femoop::Model beam(const femoop::Section& section)
{
    using enum femoop::SupportKind;
    FrameMaker made(section, {.id = "steel", .E = 205e6, .fy = 250e3});
    made.node("A", 0, 0, Fixed).node("B", L, 0, Roller).node("C", L + l, 0, Roller).member("A", "B").member("B", "C");
    made.uniform("AB", -q).model.load_cases[0].id = "first";
    made.model.add(femoop::LoadCase{.id = "second", .members = {down_on(MemberId(1))}});
    return made.model;
}

Session session_with(femoop::Model model) { return Session(Document{.model = std::move(model), .companion = {}}); }

ui::ExportToApp handed(Offer offer)
{
    REQUIRE(std::holds_alternative<ui::ExportToApp>(offer));
    return std::get<ui::ExportToApp>(std::move(offer));
}

std::string refused(Offer offer)
{
    REQUIRE(std::holds_alternative<Notice>(offer));
    return ui::Catalogue()(std::get<Notice>(offer).sentence);
}

mohr::Solution circle_of(const Session& session)
{
    const ui::ExportToApp exported = handed(circle_at_section(session));
    CHECK(exported.program == "mohr");
    auto read = mohr::read_file_text(exported.document);
    REQUIRE(std::holds_alternative<mohr::Document>(read));
    return mohr::solve(std::get<mohr::Document>(read));
}

} // namespace

TEST_SUITE("frame session")
{
    TEST_CASE("With nothing selected the whole structure is handed to moment distribution in the case that is shown")
    {
        Session session = session_with(beam(rectangle()));
        session.view.load_case = femoop::CaseId(1);
        const ui::ExportToApp exported = handed(moment_distribution(session));
        CHECK(exported.program == "cross");
        const cross::Document document = cross::read_document(exported.document);
        CHECK(document.model.members.size() == 2);
        CHECK(document.model.case_name(document.method.load_case) == "second");
        CHECK(held_nodes(session).empty());
    }

    TEST_CASE("A case is handed over though another one is faulty, and a faulty one is refused with its reason")
    {
        femoop::Model model = beam(rectangle());
        model.load_cases.push_back(
            {.id = "gone",
             .members = {{MemberId(0), femoop::PointLoad{.at = femoop::Quantity(2.0 * L),
                                                         .components = {{Dof::uy, femoop::Quantity(-7.0)}}}}}});
        Session session = session_with(model);
        REQUIRE(session.solution().blank_case(femoop::CaseId(2)));
        const cross::Document whole = cross::read_document(handed(moment_distribution(session)).document);
        CHECK(cross::solve(whole).faults.empty());
        CHECK(whole.model.case_name(whole.method.load_case) == "first");
        session.selection = Part(MemberId(0));
        CHECK(cross::solve(cross::read_document(handed(moment_distribution(session)).document)).faults.empty());
        CHECK(circle_of(session).section);
        const Cut cut = *cut_for_circle(session);
        session.view.load_case = femoop::CaseId(2);
        CHECK(std::holds_alternative<Notice>(moment_distribution(session)));
        CHECK(std::holds_alternative<Notice>(circle_at_section(session)));
        CHECK(std::holds_alternative<ui::ExportToApp>(circle_at(session, cut, femoop::CaseId(0)))); // a link goes on
    }

    TEST_CASE("Selected members alone are handed over and fixed where they met others")
    {
        Session session = session_with(beam(rectangle()));
        session.selection = Part(MemberId(0));
        CHECK(held_nodes(session) == "B");
        const cross::Document document = cross::read_document(handed(moment_distribution(session)).document);
        REQUIRE(document.model.members.size() == 1);
        const auto& model = document.model;
        CHECK(model[*model.find_node("B")].support->kind == femoop::SupportKind::Fixed);
        CHECK(cross::solve(document).task->problem.loading.fixed_end[0] == doctest::Approx(q * L * L / 12.0));
    }

    TEST_CASE("What moment distribution cannot do is told before it is started with the library's own reason")
    {
        femoop::Model truss = beam(rectangle());
        truss.analysis = femoop::AnalysisKind::Truss2d;
        truss.load_cases.clear();
        truss.add(femoop::LoadCase{.id = "P"});
        const Offer offer = moment_distribution(session_with(truss));
        REQUIRE(std::holds_alternative<Notice>(offer));
        CHECK(!std::get<Notice>(offer).faults.empty());
    }

    TEST_CASE("Where moment distribution cannot work its command says why, and can again once the cause is gone")
    {
        femoop::Model model = beam(rectangle());
        model.nodes[1].support->kind = femoop::SupportKind::Pin;
        model.materials[0].alpha = 1.2e-5;
        model.add(femoop::LoadCase{.id = "warm", .members = {{MemberId(0), femoop::TemperatureLoad{20.0, 20.0}}}});
        Workspace workspace(session_with(model));
        const DistributionCheck& check = workspace.distribution;
        CHECK(!check.why_not(workspace.session));
        workspace.session.view.load_case = femoop::CaseId(2);
        const auto reason = check.why_not(workspace.session);
        REQUIRE(reason);
        CHECK(ui::Catalogue()(*reason) ==
              "case warm: a temperature or misfit would change the length of members that are held at both ends (AB), "
              "and moment distribution takes members as axially rigid; let an end move along the member, or distribute "
              "another case");
        workspace.session.selection = Part(MemberId(1));
        CHECK(!check.why_not(workspace.session));
        workspace.session.selection.clear();
        workspace.session.change(
            {"Slide", [](Document& document) { document.model.nodes[1].support->kind = femoop::SupportKind::Roller; }});
        CHECK(!check.why_not(workspace.session));
        workspace.session.undo();
        CHECK(check.why_not(workspace.session));
    }

    TEST_CASE("The selected member goes to Mohr's circle where its moment is largest at its hardest stressed fibre")
    {
        Session session = session_with(beam(rectangle()));
        session.selection = Part(MemberId(0));
        const double M = session.solution()
                             .results->at("first")
                             .curve(MemberId(0))
                             .value(femoop::MemberComponent::Mz, 0.0); // at the wall
        const double W = 1e9 * b * h * h / 6.0;
        const mohr::Solution circle = circle_of(session);
        CHECK(std::abs(circle.state.components.x) == doctest::Approx(1e6 * std::abs(M) / W).epsilon(1e-5));
        CHECK(circle.state.components.xy == doctest::Approx(0.0));
    }

    TEST_CASE("A pinned reading is the section whose circle is drawn, N and V and M with their signs")
    {
        Session session = session_with(beam(rectangle()));
        session.selection = Part(MemberId(1));
        session.pin = Cut{MemberId(0), 0.25 * L};
        const auto read = mohr::read_file_text(handed(circle_at_section(session)).document);
        const auto& document = std::get<mohr::Document>(read);
        const femoop::SectionForces f = session.solution().results->at("first").curve(MemberId(0)).forces(0.25 * L);
        REQUIRE(document.subject == mohr::Subject::Section);
        CHECK(document.section == "rectangle b=90mm h=210mm");
        CHECK(document.state()[0] == "0 kN");
        CHECK(std::stod(document.state()[1]) == doctest::Approx(f.Vy).epsilon(1e-5));
        CHECK(std::stod(document.state()[2]) == doctest::Approx(f.Mz).epsilon(1e-5));
        CHECK(document.elasticity[0] == "205000 N/mm^2");
        CHECK(document.strengths[0] == "250 N/mm^2");
    }

    TEST_CASE("An outermost fibre stays within its section when its place is rounded")
    {
        Session session = session_with(beam(tee()));
        session.selection = Part(MemberId(0));
        const ui::ExportToApp exported = handed(circle_at_section(session));
        const auto read = mohr::read_file_text(exported.document);
        REQUIRE(std::holds_alternative<mohr::Document>(read));
        CHECK(std::get<mohr::Document>(read).state()[3] == "-267.307 mm");
    }

    TEST_CASE("A section of numbers alone has no fibres and nothing to point at is told")
    {
        Session session = session_with(beam({.id = "S", .A = 0.01, .Iz = 1e-4}));
        CHECK(refused(circle_at_section(session)).find("select one member") != std::string::npos);
        session.selection = Part(MemberId(0));
        CHECK(refused(circle_at_section(session)).find("section S") != std::string::npos);
    }

    TEST_CASE("A profile with a second moment of its own has no fibres that are known")
    {
        Session session = session_with(beam({.id = "S", .profile = "IPE 300", .Iz = 1e-4}));
        session.selection = Part(MemberId(0));
        CHECK(refused(circle_at_section(session)).find("section S is IPE 300 with an area") != std::string::npos);
    }

    TEST_CASE("Results that are kept from the class are not told by a circle either")
    {
        Session session = session_with(beam(rectangle()));
        session.selection = Part(MemberId(0));
        session.hidden = session.view.show;
        CHECK(refused(circle_at_section(session)).find("hidden") != std::string::npos);
    }
}
