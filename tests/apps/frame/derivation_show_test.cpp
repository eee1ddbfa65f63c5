#include "apps/frame/session/derivation_show.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include <string>

#include "apps/frame/document/command.h"
#include "apps/frame/document/drawing.h"
#include "apps/frame/session/derivation_commands.h"
#include "femoop/methods/influence/effect_name.h"
#include "femoop/methods/influence/influence_line.h"
#include "tests/apps/frame/example_workspace.h"

using namespace frame;
using femoop::ExpectedQuantity;
using femoop::MemberComponent;
using femoop::MovingEffect;
using femoop::derivation::StepKind;
using frame_test::run;
using frame_test::workspace_with;

namespace {

MovingEffect moment(const Session& session, const std::string& member, double x)
{
    return {.member = session.model().find_member(member), .component = MemberComponent::Mz, .at = femoop::Quantity(x)};
}

MovingEffect reaction(const Session& session, const std::string& node, femoop::Dof dof)
{
    return {.quantity = ExpectedQuantity::Reaction, .node = session.model().find_node(node), .dof = dof};
}

std::string explained(const Workspace& workspace)
{
    const auto* const derivation = workspace.derivation.derivation();
    return derivation ? femoop::influence::effect_name(workspace.session.model(), derivation->effect) : "";
}

std::string refusal(Workspace& workspace)
{
    workspace.derivation.follow(workspace.session);
    return workspace.derivation.why_none() ? ui::Catalogue()(*workspace.derivation.why_none()) : "";
}

} // namespace

TEST_SUITE("frame session")
{
    TEST_CASE("Asked why, a section's moment is derived in steps that stop at the first and the last")
    {
        Workspace workspace = workspace_with("portal.json");
        CHECK(run(workspace, "derivation.next") == "no number is explained; point at one and press W");
        CHECK(run(workspace, "view.why") == "point at a number of the picture or of a table of results first");
        workspace.notify("point at a number of the picture or of a table of results first");
        workspace.pointed_number = {moment(workspace.session, "BC", 3.0)};
        CHECK(!run(workspace, "view.why"));
        CHECK(!workspace.session.notice); // it says what is done now
        CHECK(explained(workspace) == "M(BC, 3 m)");
        CHECK(workspace.derivation.n_steps() == 11);
        CHECK(workspace.derivation.shown_step()->kind == StepKind::Member);
        CHECK(!run(workspace, "derivation.previous"));
        CHECK(workspace.derivation.step() == 0);
        CHECK(!run(workspace, "derivation.last"));
        CHECK(!run(workspace, "derivation.next"));
        CHECK(workspace.derivation.shown_step()->kind == StepKind::Superposition);
        CHECK(!run(workspace, "derivation.close"));
        CHECK_FALSE(workspace.bottom.is_open);
    }

    TEST_CASE("The numbers of one place follow one another round")
    {
        Workspace workspace = workspace_with("portal.json");
        explain(workspace, {moment(workspace.session, "BC", 3.0)});
        for (const char* const next : {"u(BC, 3 m)", "v(BC, 3 m)", "N(BC, 3 m)", "V(BC, 3 m)", "M(BC, 3 m)"}) {
            CHECK(!run(workspace, "derivation.next_number"));
            CHECK(explained(workspace) == next);
        }
        CHECK(!run(workspace, "derivation.previous_number"));
        CHECK(explained(workspace) == "V(BC, 3 m)");
        explain(workspace, {reaction(workspace.session, "A", femoop::Dof::rz)});
        CHECK(!run(workspace, "derivation.next_number"));
        CHECK(explained(workspace) == "ux(A)");
    }

    TEST_CASE("From an extreme one walks to the other numbers of its place")
    {
        Workspace workspace = workspace_with("portal.json");
        MovingEffect extreme = moment(workspace.session, "BC", 0.0);
        extreme.quantity = ExpectedQuantity::Extreme;
        extreme.at.reset();
        explain(workspace, {extreme});
        CHECK(!run(workspace, "derivation.previous_number"));
        CHECK(explained(workspace) == "V(BC, 4 m)");
        CHECK(!run(workspace, "derivation.next_number"));
        CHECK(explained(workspace) == "M(BC, 4 m)");
    }

    TEST_CASE("What is explained follows an edit, and the case that is shown")
    {
        Workspace workspace = workspace_with("portal.json");
        Session& session = workspace.session;
        explain(workspace, {moment(session, "BC", 3.0)});
        const double before = workspace.derivation.derivation()->value;
        session.change({"Double it", [](Document& document) {
                            for (femoop::MemberLoad& load : document.model.load_cases[0].members)
                                if (auto* const q = std::get_if<femoop::DistributedLoad>(&load.load))
                                    q->values[0].start = femoop::Quantity(2.0 * q->values[0].start.value());
                        }});
        workspace.derivation.follow(session);
        CHECK(workspace.derivation.derivation()->value != before);
        const std::size_t steps = workspace.derivation.n_steps();
        session.view.load_case = *session.model().find_case("ULS");
        workspace.derivation.follow(session);
        CHECK(workspace.derivation.n_steps() > steps);
        CHECK(workspace.derivation.derivation()->steps.back().kind == StepKind::Combination);
    }

    TEST_CASE("The force method is played as a derivation is, and follows the document")
    {
        Workspace workspace = workspace_with("portal.json");
        CHECK(!run(workspace, "view.force_method"));
        const DerivationShow& show = workspace.derivation;
        REQUIRE(show.force_method() != nullptr);
        CHECK(show.force_method()->n_redundants() == 3);
        CHECK(show.shown_step()->kind == StepKind::Redundants);
        CHECK(show.n_steps() == 10);
        CHECK(!run(workspace, "derivation.last"));
        CHECK(show.shown_step()->kind == StepKind::StateSuperposition);
        Session& session = workspace.session;
        session.change({"Pin it", [](Document& document) {
                            for (femoop::Node& node : document.model.nodes)
                                if (node.support) node.support->kind = femoop::SupportKind::Pin;
                        }});
        workspace.derivation.follow(session);
        CHECK(show.force_method()->n_redundants() == 1);
        explain(workspace, {moment(session, "BC", 3.0)});
        CHECK(show.force_method() == nullptr);
    }

    TEST_CASE("An ordinate is explained as the effect under a unit load there, and follows the load")
    {
        Workspace workspace = workspace_with("bridge.json");
        Session& session = workspace.session;
        session.influence.ask(session.model(), drawing::Cut{*session.model().find_member("BC"), 40.0});
        REQUIRE(session.shown_line() != nullptr);
        const auto line = session.shown_line()->line;
        CHECK(run(workspace, "view.why") == "point at an ordinate of the line, or put a load on it (U, R)");
        workspace.pointed_number = {.effect = line.effect,
                                    .under = LoadOnLine{.place = {.position = 80.0}, .is_unit_load = true}};
        CHECK(!run(workspace, "view.why"));
        REQUIRE(workspace.derivation.derivation() != nullptr);
        CHECK(workspace.derivation.derivation()->value == doctest::Approx(line.ordinates.value(80.0)));
        session.influence.put_train({.position = 150.0});
        workspace.derivation.follow(session);
        CHECK(workspace.derivation.derivation()->value == doctest::Approx(line.ordinates.value(150.0)));
        session.influence.clear();
        CHECK(refusal(workspace) == "The load is gone from the influence line; point at an ordinate and press W.");
    }

    TEST_CASE("Of a train on the line its effect is explained where it stands, and at each candidate")
    {
        Workspace workspace = workspace_with("bridge.json");
        Session& session = workspace.session;
        session.influence.ask(session.model(), drawing::Cut{*session.model().find_member("BC"), 40.0});
        session.influence.choose_train("HS20");
        REQUIRE(session.shown_line() != nullptr);
        CHECK(!run(workspace, "view.why"));
        REQUIRE(workspace.derivation.derivation() != nullptr);
        CHECK(workspace.derivation.derivation()->value == doctest::Approx(session.influence.standing()->placing.value));
        const CandidatePosition candidate = session.influence.candidates().front();
        workspace.pointed_number = {.effect = session.shown_line()->line.effect,
                                    .under = LoadOnLine{{candidate.position, candidate.reversed}}};
        CHECK(!run(workspace, "view.why"));
        CHECK(workspace.derivation.derivation()->value == doctest::Approx(candidate.value));
    }

    TEST_CASE("Forces are released one by one where the pointer is, held again, and refused with the motion")
    {
        Workspace workspace = workspace_with("portal.json");
        const Session& session = workspace.session;
        CHECK(run(workspace, "view.release") == "point at a support, or at a section of a diagram first");
        const auto release = [&](const MovingEffect& force) {
            workspace.pointed_number = {force};
            CHECK(!run(workspace, "view.release"));
        };
        const auto released = [&] { return workspace.derivation.force_method()->redundants; };
        const MovingEffect hinge = moment(session, "BC", 0.0), foot = reaction(session, "D", femoop::Dof::rz);
        release(hinge);
        release(foot);
        CHECK(released() == std::vector{hinge, foot});
        release(hinge);
        CHECK(released() == std::vector{foot});
        release(hinge);
        release(moment(session, "BC", 4.0));
        CHECK(released().size() == 3);
        release(reaction(session, "A", femoop::Dof::rz));
        CHECK(released().size() == 3); // a fourth hinge lets it move
        const auto& refused = workspace.refused_release;
        REQUIRE(refused);
        CHECK(refused->moves(session));
        const std::string reason = ui::Catalogue()(refused->reason);
        CHECK(reason.starts_with("the structure does not stand without "));
        CHECK(reason.find("can move") == reason.rfind("can move")); // it is said once
        CHECK(reason.find("can move") != std::string::npos);
        CHECK(reason.find("add a ") == std::string::npos); // what mends a structure is no remedy here
        CHECK(refused->primary.nodes.size() == session.model().nodes.size() + 1); // that of the hinge inside BC
        CHECK(refused->motions.front().motion.size() == refused->primary.nodes.size());
        const MovingEffect sway{
            .quantity = ExpectedQuantity::Displacement, .node = session.model().find_node("B"), .dof = femoop::Dof::ux};
        workspace.pointed_number = {sway};
        CHECK(run(workspace, "view.release") ==
              "a displacement is no force; point at a support, or at a section of a diagram");
        CHECK(refused->moves(session));
        release(reaction(session, "B", femoop::Dof::uy));
        CHECK(ui::Catalogue()(session.notice->sentence).find("has no support") != std::string::npos);
        CHECK(!refused->moves(session)); // it is told, not drawn
        CHECK(released().size() == 3);
    }

    TEST_CASE("The largest moment of a member is released by a hinge where it stands, and held again")
    {
        Workspace workspace = workspace_with("portal.json");
        MovingEffect largest = moment(workspace.session, "BC", 0.0);
        largest.quantity = ExpectedQuantity::Extreme;
        largest.at.reset();
        workspace.pointed_number = {largest};
        CHECK(!run(workspace, "view.release"));
        REQUIRE(workspace.derivation.force_method() != nullptr);
        const auto& redundants = workspace.derivation.force_method()->redundants;
        REQUIRE(redundants.size() == 1);
        CHECK(femoop::influence::effect_name(workspace.session.model(), redundants.front()) == "M(BC, 4 m)");
        CHECK(!run(workspace, "view.release"));
        CHECK(!workspace.bottom.shows(BottomContent::Derivation));
    }

    TEST_CASE("Steps count in the units from which that of the number follows, and what is released stays where it is")
    {
        Workspace workspace = workspace_with("portal.json");
        Session& session = workspace.session;
        const MovingEffect section = moment(session, "BC", 3.0);
        const DerivationShow& show = workspace.derivation;
        explain(workspace, {section});
        const double value = show.derivation()->value; // kN·m
        REQUIRE(session.view.unit_choices.choose("moment", "kN*cm"));
        workspace.derivation.follow(session);
        CHECK(femoop::name(show.model(session).units.length) == "cm");
        CHECK(show.derivation()->value == doctest::Approx(100.0 * value));
        CHECK(show.derivation()->closing_error < 1e-6);
        CHECK(femoop::influence::effect_name(show.model(session), show.derivation()->effect) == "M(BC, 300 cm)");
        CHECK(!run(workspace, "derivation.next_number"));
        workspace.derivation.follow(session);
        CHECK(femoop::name(show.model(session).units.length) == "m"); // u has none that was chosen
        workspace.pointed_number = {section};
        CHECK(!run(workspace, "view.release"));
        REQUIRE(show.force_method() != nullptr);
        CHECK(femoop::influence::effect_name(show.model(session), show.force_method()->redundants[0]) ==
              "M(BC, 300 cm)");
        CHECK(femoop::influence::effect_name(session.model(), show.redundants()[0]) == "M(BC, 3 m)");
        CHECK(!run(workspace, "view.release"));
        CHECK(!workspace.bottom.shows(BottomContent::Derivation));
    }

    TEST_CASE("A bar that is pointed at anywhere is a redundant: it is cut at its end, and held again")
    {
        Workspace workspace = workspace_with("truss.json");
        const femoop::Model& model = workspace.session.model();
        workspace.session.change(
            {"Brace", [](Document& document) { // one bar more than statics needs
                 femoop::Model& changed = document.model;
                 changed.nodes[changed.find_node("B")->index].support->kind = femoop::SupportKind::Pin;
             }});
        const auto point_at = [&](const char* bar, double at) {
            workspace.pointed_number = {MovingEffect{.quantity = ExpectedQuantity::SectionForce,
                                                     .member = model.find_member(bar),
                                                     .component = femoop::MemberComponent::N,
                                                     .at = femoop::Position(femoop::Quantity(at))}};
            CHECK(!run(workspace, "view.release"));
        };
        point_at("AC", 1.3);
        REQUIRE(workspace.derivation.force_method() != nullptr);
        CHECK(workspace.derivation.force_method()->redundants.size() == 1);
        CHECK(!workspace.refused_release);
        point_at("AC", 2.9);
        CHECK(!workspace.bottom.shows(BottomContent::Derivation));
    }

    TEST_CASE("A place beyond the end of a shorter member is its end; a number whose support is gone is lost")
    {
        Workspace workspace = workspace_with("portal.json");
        Session& session = workspace.session;
        explain(workspace, {moment(session, "BC", 7.5)});
        const femoop::NodeId c = *session.model().find_node("C");
        session.change(
            {"Nearer", [&](Document& document) { document.model.nodes[c.index].at[0] = femoop::Quantity(6.0); }});
        workspace.derivation.follow(session);
        CHECK(explained(workspace) == "M(BC, 6 m)");
        explain(workspace, {reaction(session, "A", femoop::Dof::uy)});
        session.change({"Free", [](Document& document) { document.model.nodes[0].support.reset(); }});
        workspace.derivation.follow(session);
        CHECK(workspace.derivation.is_lost());
        CHECK(ui::Catalogue()(workspace.derivation.lost()) == "The number that was explained is gone from node A.");
    }

    TEST_CASE("Of an envelope the case that governs is followed, of a cell of a table the case that the cell is of")
    {
        Workspace workspace = workspace_with("portal.json");
        Session& session = workspace.session;
        session.view.is_envelope = true;
        const MovingEffect corner = moment(session, "BC", 0.0);
        explain(workspace, {corner});
        REQUIRE(workspace.derivation.derivation() != nullptr);
        CHECK(workspace.derivation.derivation()->steps.front().kind == StepKind::Governing);
        const femoop::Results& results = *session.solution().results;
        double largest = 0.0;
        for (std::size_t c = 0; c < session.model().n_cases(); ++c)
            largest = std::max(largest, std::abs(femoop::influence::effect_in(corner, results[femoop::CaseId(c)])));
        CHECK(std::abs(workspace.derivation.derivation()->value) == largest);

        const femoop::CaseId wind = *session.model().find_case("W");
        explain(workspace, {.effect = corner, .of = wind});
        CHECK(workspace.derivation.derivation()->load_case == wind);
        CHECK(workspace.derivation.derivation()->steps.front().kind == StepKind::Member);
        CHECK(run(workspace, "view.force_method")->starts_with("an envelope has the numbers of several cases"));
    }

    TEST_CASE("What was kept is followed in its own model, and a difference from it is followed from what is now")
    {
        Workspace workspace = workspace_with("portal.json");
        Session& session = workspace.session;
        CHECK(!run(workspace, "view.compare"));
        session.change({"Lengthen", [](Document& document) {
                            for (femoop::Node& node : document.model.nodes)
                                node.at[0] = femoop::Quantity(2.0 * node.at[0].value());
                        }});
        const MovingEffect middle = moment(session, "BC", 8.0);
        const MovingEffect middle_kept = moment(session, "BC", 4.0); // of a member half as long
        const auto value = [&](Compared compared) {
            explain(workspace, {.effect = middle, .compared = compared});
            REQUIRE(workspace.derivation.derivation() != nullptr);
            return workspace.derivation.derivation()->value;
        };
        const femoop::Results& results = *session.solution().results;
        const double now = femoop::influence::effect_in(middle, results[femoop::CaseId(0)]);
        const double kept = femoop::influence::effect_in(middle_kept, session.reference->results[femoop::CaseId(0)]);
        CHECK(value(Compared::Now) == doctest::Approx(now));
        CHECK(value(Compared::Kept) == doctest::Approx(kept));
        CHECK(workspace.derivation.is_of_kept_model());
        CHECK(workspace.derivation.model(session) == session.reference->model);
        CHECK(value(Compared::Change) == doctest::Approx(now - kept));
        CHECK_FALSE(workspace.derivation.is_of_kept_model());
        CHECK(workspace.derivation.derivation()->steps.back().kind == StepKind::Difference);
        CHECK(!run(workspace, "view.compare"));
        CHECK(refusal(workspace) == "What this number was compared with is gone.");
    }

    TEST_CASE("Asked of a table, the player goes back to it")
    {
        Workspace workspace = workspace_with("portal.json");
        workspace.bottom = {.is_open = true, .table = TableKind::Reactions};
        explain(workspace, {moment(workspace.session, "BC", 3.0)});
        explain(workspace, {moment(workspace.session, "BC", 2.0)});
        CHECK(workspace.bottom.shows(BottomContent::Derivation));
        close_derivation(workspace);
        CHECK(workspace.bottom.shows(BottomContent::Table));
        CHECK(workspace.bottom.table == TableKind::Reactions);
        explain(workspace, {moment(workspace.session, "BC", 3.0)});
        workspace.bottom.is_open = true;
        close_derivation(workspace);
        CHECK(workspace.bottom.shows(BottomContent::Table));
    }

    TEST_CASE("A bar of a truss that nothing loads between its nodes has N alone")
    {
        Workspace workspace = workspace_with("truss.json");
        MovingEffect force = moment(workspace.session, workspace.session.model().members[0].id, 0.0);
        force.component = femoop::MemberComponent::N;
        const auto is_force = [](const MovingEffect& one) { return one.quantity == ExpectedQuantity::SectionForce; };
        const auto beside = numbers_beside(workspace.session.model(), force);
        CHECK(std::ranges::count_if(beside, is_force) == 1);
    }

    TEST_CASE("Hidden results and a mechanism have no derivation, and it is said why; a tied member has one")
    {
        Workspace workspace = workspace_with("portal.json");
        Session& session = workspace.session;
        explain(workspace, {moment(session, "BC", 3.0)});
        session.hidden = ShowSet{Show::M};
        CHECK(refusal(workspace) == "The results are hidden; H reveals them.");
        session.hidden.reset();
        CHECK(refusal(workspace).empty());
        session.change({"Stiffen", [](Document& document) { document.model.members[0].inextensible = true; }});
        CHECK(refusal(workspace).empty());
        session.undo();
        session.change({"Free", [](Document& document) {
                            for (femoop::Node& node : document.model.nodes) node.support.reset();
                        }});
        CHECK(refusal(workspace) == "There are no results: see the problems.");
    }
}
