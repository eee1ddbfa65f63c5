#include "apps/frame/session/influence_commands.h"

#include <doctest/doctest.h>

#include <string>

#include "apps/frame/document/command.h"
#include "apps/frame/document/drawing.h"
#include "femoop/methods/influence/effect_name.h"
#include "tests/apps/frame/example_workspace.h"

using namespace frame;
using femoop::MemberId;
using femoop::NodeId;
using frame_test::run;
using frame_test::workspace_with;

namespace {

std::string asked(const Session& session)
{
    const auto effect = session.influence.effect(session.model());
    return effect ? femoop::influence::effect_name(session.model(), *effect) : "";
}

const drawing::InfluencePicture* line(const Session& session)
{
    return session.influence.picture(session.model(), session.generation(), session.view);
}

} // namespace

TEST_SUITE("frame session")
{
    TEST_CASE("The line of a section goes from quantity to quantity, and on where a quantity was left")
    {
        Workspace workspace = workspace_with("bridge.json");
        Session& session = workspace.session;
        CHECK(run(workspace, "view.influence.next") ==
              "no influence line is shown; press I and click a section or a support");
        session.influence.ask(session.model(), drawing::Cut{MemberId(1), 40.0});
        CHECK(asked(session) == "M(BC, 40 ft)");
        for (const char* next : {"u(BC, 40 ft)", "v(BC, 40 ft)", "N(BC, 40 ft)"}) {
            CHECK(!run(workspace, "view.influence.next"));
            CHECK(asked(session) == next);
        }
        CHECK(!run(workspace, "view.influence.next"));
        CHECK(asked(session) == "V(BC, 40 ft)");
        session.influence.ask(session.model(), drawing::Cut{MemberId(0), 10.0});
        CHECK(asked(session) == "V(AB, 10 ft)");
        CHECK(!run(workspace, "view.influence.close"));
        CHECK(line(session) == nullptr);
    }

    TEST_CASE("The line follows what is changed, and is gone with its member")
    {
        Workspace workspace = workspace_with("portal.json");
        Session& session = workspace.session;
        session.influence.ask(session.model(), drawing::Cut{*session.model().find_member("BC"), 4.0});
        REQUIRE(line(session) != nullptr);
        const double before = line(session)->line.ordinates.largest();
        const NodeId foot = *session.model().find_node("A");
        session.change({"Free", [=](Document& document) { set_support(document, foot, femoop::SupportKind::Pin); }});
        REQUIRE(line(session) != nullptr);
        CHECK(line(session)->line.ordinates.largest() > before); // the beam is held less
        session.change({"Delete", [](Document& document) {
                            remove(document, std::vector<Part>{*document.model.find_member("BC")});
                        }});
        CHECK(line(session) == nullptr);
        CHECK(!session.influence.is_on(session.model())); // so that results are seen again
        session.undo();
        CHECK(line(session) != nullptr);
    }

    TEST_CASE("A support tells the reaction that it bears, a node without one its displacement")
    {
        Workspace workspace = workspace_with("portal.json");
        Session& session = workspace.session;
        session.influence.ask(session.model(), *session.model().find_node("A"));
        CHECK(asked(session) == "fy(A)");
        CHECK(session.influence.choices(session.model()).size() == 3);
        session.influence.ask(session.model(), *session.model().find_node("B"));
        CHECK(asked(session) == "uy(B)");
        REQUIRE(line(session) != nullptr);
        CHECK(line(session)->path.members.front().member == *session.model().find_member("BC"));
    }

    TEST_CASE(
        "Behind the forces of a place come its displacements that no support holds, and a section is dragged with one")
    {
        Workspace workspace = workspace_with("bridge.json");
        Session& session = workspace.session;
        const auto all_at = [&](const auto& place) {
            session.influence.ask(session.model(), place);
            std::string names;
            for (const auto& choice : session.influence.choices(session.model()))
                names += femoop::influence::component_name(session.model().analysis, choice) + " ";
            return names;
        };
        CHECK(all_at(drawing::Cut{MemberId(1), 40.0}) == "N V M u v ");
        CHECK(all_at(*session.model().find_node("A")) == "fx fy rz ");
        CHECK(all_at(*session.model().find_node("B")) == "fy ux rz ");
        session.influence.ask(session.model(), drawing::Cut{MemberId(1), 40.0});
        session.influence.choose(session.influence.choices(session.model()).back());
        CHECK(asked(session) == "v(BC, 40 ft)");
        session.influence.ask(session.model(), drawing::Cut{MemberId(1), 52.0});
        CHECK(asked(session) == "v(BC, 52 ft)");
        REQUIRE(line(session) != nullptr);
        const auto& line_of_v = line(session)->line;
        CHECK(line_of_v.effect.quantity == femoop::ExpectedQuantity::Displacement);
        CHECK(line_of_v.ordinates.min().value < 0.0); // down where the load stands
    }

    TEST_CASE("A bar of a truss tells its force, under a load that passes the longest chord")
    {
        Workspace workspace = workspace_with("truss.json");
        Session& session = workspace.session;
        session.influence.ask(session.model(), drawing::Cut{*session.model().find_member("CD"), 1.0});
        CHECK(asked(session) == "N(CD, 1 m)");
        REQUIRE(line(session) != nullptr);
        CHECK(line(session)->line.ordinates.max().value == doctest::Approx(1.0)); // all of a load at C hangs on it
    }

    TEST_CASE("A unit load traces the line as far as it comes, and its structure says the ordinate at the section")
    {
        Workspace workspace = workspace_with("bridge.json");
        Session& session = workspace.session;
        session.influence.ask(session.model(), drawing::Cut{MemberId(1), 40.0});
        CHECK(!run(workspace, "view.influence.trace"));
        REQUIRE(line(session) != nullptr);
        REQUIRE(line(session)->traced.has_value());
        CHECK(line(session)->traced->to == 0.0);
        for (const double s : {30.0, 77.0, 160.0, 55.0}) {
            CAPTURE(s);
            session.influence.put_train({.position = s});
            REQUIRE(line(session) != nullptr);
            const double ordinate = line(session)->line.ordinates.value(s);
            const auto moment = session.influence.results()[femoop::CaseId(0)]
                                    .curve(MemberId(1))
                                    .value(femoop::MemberComponent::Mz, 40.0);
            CHECK(moment == doctest::Approx(ordinate).epsilon(1e-9));
        }
        CHECK(line(session)->traced->to == doctest::Approx(160.0));
        session.influence.put_train({.position = 1e3});
        REQUIRE(line(session) != nullptr);
        CHECK(!line(session)->traced.has_value());
        session.influence.ask(session.model(), drawing::Cut{MemberId(1), 20.0}); // another line, from its beginning
        REQUIRE(line(session) != nullptr);
        CHECK(line(session)->traced->to == 0.0);
        CHECK(!run(workspace, "view.influence.trace"));
        CHECK(line(session)->forces.empty());
    }

    TEST_CASE("A unit load stands on the path where a line has no such extreme, too")
    {
        Workspace workspace = workspace_with("portal.json");
        Session& session = workspace.session;
        session.influence.ask(session.model(), *session.model().find_node("A"));
        CHECK(!run(workspace, "view.influence.trace"));
        for (const auto kind : {femoop::ExtremeKind::Max, femoop::ExtremeKind::Min}) {
            session.influence.seek(kind);
            REQUIRE(line(session) != nullptr);
            CHECK(line(session)->forces.size() == 1);
        }
    }

    TEST_CASE("A line that is asked for again at the place where one was closed stands alone, and a train whole")
    {
        Workspace workspace = workspace_with("bridge.json");
        Session& session = workspace.session;
        const auto ask = [&] { session.influence.ask(session.model(), drawing::Cut{MemberId(1), 40.0}); };
        for (const char* beside : {"train.next", "view.influence.trace"}) {
            CAPTURE(beside);
            ask();
            CHECK(!run(workspace, beside));
            REQUIRE(line(session) != nullptr);
            const std::size_t n_forces = line(session)->forces.size();
            CHECK(!run(workspace, "view.influence.close"));
            CHECK(line(session) == nullptr);
            ask();
            REQUIRE(line(session) != nullptr);
            CHECK(session.influence.standing() == nullptr);
            CHECK(line(session)->forces.empty());
            CHECK(!line(session)->traced.has_value());
            CHECK(!run(workspace, beside));
            REQUIRE(line(session) != nullptr);
            CHECK(session.influence.standing() != nullptr);
            CHECK(line(session)->forces.size() == n_forces);
            CHECK(!run(workspace, "view.influence.close"));
        }
    }

    TEST_CASE("A line of a displacement is by Maxwell's theorem what a unit load or a unit couple there moves")
    {
        Workspace workspace = workspace_with("bridge.json");
        Session& session = workspace.session;
        const auto principle_of = [&](femoop::Dof dof) {
            const femoop::MovingEffect effect{
                .quantity = femoop::ExpectedQuantity::Displacement, .node = NodeId(1), .dof = dof};
            return drawing::principle(session.model(), effect, session.tr());
        };
        CHECK(principle_of(femoop::Dof::ux) ==
              "A unit load stands there; the path moves by the line (Maxwell): 1 · ux = 1 · η(s).");
        CHECK(principle_of(femoop::Dof::rz) ==
              "A unit couple stands there; the path moves by the line (Maxwell): 1 · rz = 1 · η(s).");
    }

    TEST_CASE("A look at a model that has not the line does not part it from its train")
    {
        Workspace workspace = workspace_with("bridge.json");
        Session& session = workspace.session;
        session.influence.ask(session.model(), drawing::Cut{MemberId(1), 40.0});
        CHECK(!run(workspace, "train.next"));
        REQUIRE(line(session) != nullptr);
        const femoop::Model without{};
        CHECK(session.influence.picture(without, session.generation(), session.view) == nullptr);
        REQUIRE(line(session) != nullptr);
        CHECK(session.influence.standing() != nullptr);
    }

    TEST_CASE("A structure that can move has no influence lines, and the tool says why")
    {
        Workspace workspace = workspace_with("mechanism.json");
        CHECK(run(workspace, "draw.influence") == "the model has no results");
        workspace.session.influence.ask(workspace.session.model(), NodeId(0));
        CHECK(line(workspace.session) == nullptr);
    }
}
