#include "apps/frame/session/train_commands.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "femoop/methods/influence/train/standing_train.h"
#include "femoop/methods/influence/train/train_analysis.h"
#include "tests/apps/frame/example_workspace.h"

using namespace frame;
using doctest::Approx;
using femoop::ExtremeKind;
using femoop::MemberId;
using frame_test::run;
using frame_test::workspace_with;

namespace {

constexpr std::string_view no_line = "no influence line is shown; press I and click a section or a support";

/// The bridge of three spans with the line of the moment in the middle of its second.
Workspace bridge()
{
    Workspace workspace = workspace_with("bridge.json");
    workspace.session.influence.ask(workspace.session.model(), drawing::Cut{MemberId(1), 40.0});
    return workspace;
}

const drawing::InfluencePicture* picture(const Workspace& workspace)
{
    const Session& session = workspace.session;
    return session.influence.picture(session.model(), session.generation(), session.view);
}

/// What stands there now.
const drawing::StandingTrain& train(const Workspace& workspace)
{
    REQUIRE(picture(workspace) != nullptr);
    REQUIRE(workspace.session.influence.standing() != nullptr);
    return *workspace.session.influence.standing();
}

/// What the forces and the uniform load come to by the line's ordinates.
double sum(const Workspace& workspace)
{
    const drawing::StandingTrain& standing = train(workspace);
    const drawing::InfluencePicture& line = *picture(workspace);
    double sum = 0.0;
    for (const auto& force : line.forces) sum += force.force * force.ordinate;
    for (const double area : covered_areas(standing.placing, line.line.ordinates)) sum += standing.train.uniform * area;
    return sum;
}

} // namespace

TEST_SUITE("frame session")
{
    TEST_CASE("The trains of the model stand on the line one after the other, and at last none")
    {
        Workspace workspace = bridge();
        CHECK(picture(workspace) != nullptr);
        CHECK(workspace.session.influence.standing() == nullptr);
        CHECK(!run(workspace, "train.next"));
        CHECK(train(workspace).name == "HS20");
        CHECK(!run(workspace, "train.next"));
        CHECK(train(workspace).name == "lane");
        CHECK(run(workspace, "train.forth") == "the train has no axles that could be moved");
        CHECK(!run(workspace, "train.next"));
        CHECK(picture(workspace) != nullptr);
        CHECK(workspace.session.influence.standing() == nullptr);
    }

    TEST_CASE("A load path along the selected members leads the others, and trains stay on theirs")
    {
        Workspace workspace = bridge();
        Session& session = workspace.session;
        const femoop::Model before = session.model();
        const femoop::MemberId last(before.members.size() - 1);
        session.selection = {last};
        CHECK(!run(workspace, "train.path"));
        const femoop::MovingLoads& now = session.model().moving_loads;
        REQUIRE(now.paths.size() == before.moving_loads.paths.size() + 1);
        CHECK(now.paths.front().members == std::vector{last});
        for (std::size_t i = 0; i < now.trains.size(); ++i)
            CHECK(femoop::influence::members_of(session.model(), now.trains[i].path) ==
                  femoop::influence::members_of(before, before.moving_loads.trains[i].path));
        session.selection = {};
        CHECK(run(workspace, "train.path") == "no member is selected; select those that a load moves along");
    }

    TEST_CASE("A train stands where the search of the line finds it worst, and the sum of its ordinates is that value")
    {
        Workspace workspace = bridge();
        Session& session = workspace.session;
        run(workspace, "train.next");
        femoop::influence::TrainAnalysis analysis(session.model());
        const auto worst =
            analysis.search(session.model().moving_loads.trains[0], *session.influence.effect(session.model())).worst();
        CHECK(train(workspace).kind == ExtremeKind::Max);
        CHECK(train(workspace).placing.value == Approx(worst.max.value).epsilon(1e-9));
        CHECK(sum(workspace) == Approx(worst.max.value).epsilon(1e-9));
        CHECK(!run(workspace, "train.extreme"));
        CHECK(train(workspace).placing.value == Approx(worst.min.value).epsilon(1e-9));
        CHECK(sum(workspace) == Approx(worst.min.value).epsilon(1e-9));
        CHECK(train(workspace).is_worst);
    }

    TEST_CASE("Keys move a train from round place to round place, turn it about, and bring it back")
    {
        Workspace workspace = bridge();
        run(workspace, "train.next");
        CHECK(train(workspace).placing.position.value() == Approx(114.0));
        CHECK(!run(workspace, "train.forth"));
        CHECK(train(workspace).placing.position.value() == Approx(116.0));
        CHECK(!train(workspace).is_worst);
        CHECK(sum(workspace) == Approx(train(workspace).placing.value).epsilon(1e-9));
        CHECK(!run(workspace, "train.back"));
        CHECK(!run(workspace, "train.back"));
        CHECK(train(workspace).placing.position.value() == Approx(112.0));
        const double forwards = train(workspace).placing.position.value();
        CHECK(!run(workspace, "train.turn"));
        CHECK(train(workspace).placing.reversed);
        CHECK(train(workspace).placing.position.value() == Approx(forwards - 28.0));
        CHECK(sum(workspace) == Approx(train(workspace).placing.value).epsilon(1e-9));
        CHECK(!run(workspace, "train.worst"));
        CHECK(train(workspace).is_worst);
        CHECK(train(workspace).placing.position.value() == Approx(114.0));
    }

    TEST_CASE("The worst of the candidates is the train's value, and every candidate is what the train does there")
    {
        Workspace workspace = bridge();
        CHECK(run(workspace, "train.candidate.next") ==
              "no train stands on the influence line; press R or take one from the menu Trains");
        run(workspace, "train.next");
        for (int direction = 0; direction < 2; ++direction) {
            const double worst = train(workspace).placing.value;
            const bool is_max = train(workspace).kind == ExtremeKind::Max;
            const std::vector<CandidatePosition> all = workspace.session.influence.candidates();
            REQUIRE(all.size() > 10);
            double found = all.front().value;
            for (const CandidatePosition& one : all)
                found = is_max ? std::max(found, one.value) : std::min(found, one.value);
            CHECK(found == Approx(worst).epsilon(1e-9));
            for (const CandidatePosition& one : all) {
                CAPTURE(one.position);
                workspace.session.influence.put_train({one.position, one.reversed});
                const double there = train(workspace).placing.value;
                CHECK((is_max ? there - one.value : one.value - there) >
                      -1e-9 * std::abs(worst)); // the worse side counts
                CHECK(sum(workspace) == Approx(there).epsilon(1e-9));
            }
            CHECK(!run(workspace, "train.worst"));
            CHECK(!run(workspace, "train.extreme"));
        }
    }

    TEST_CASE("Keys go from candidate to candidate, and from the last one to the first")
    {
        Workspace workspace = bridge();
        run(workspace, "train.next");
        train(workspace);
        const std::vector<CandidatePosition> all = workspace.session.influence.candidates();
        workspace.session.influence.put_train({all.back().position, all.back().reversed});
        CHECK(!run(workspace, "train.candidate.next"));
        CHECK(train(workspace).placing.position.value() == Approx(all.front().position));
        CHECK(!run(workspace, "train.candidate.previous"));
        CHECK(train(workspace).placing.position.value() == Approx(all.back().position));
        CHECK(train(workspace).placing.reversed);
    }

    TEST_CASE("A train runs from where it comes onto its path to where it has left it, and no farther")
    {
        Workspace workspace = bridge();
        run(workspace, "train.next");
        train(workspace);
        workspace.session.influence.put_train({.position = 1e6});
        CHECK(train(workspace).placing.position.value() == Approx(244.0)); // 200 ft and 44 ft of train
        CHECK(std::abs(train(workspace).placing.value) < 1e-9);
        workspace.session.influence.put_train({.position = -1e6});
        CHECK(train(workspace).placing.position.value() == 0.0);
    }

    TEST_CASE("A train of the library becomes one of the document's, as one step, once")
    {
        Workspace workspace = workspace_with("portal.json");
        Session& session = workspace.session;
        CHECK(run(workspace, "train.tb450") == no_line);
        session.influence.ask(session.model(), drawing::Cut{*session.model().find_member("BC"), 2.0});
        CHECK(run(workspace, "train.next") == "the model has no trains; take one from the menu Trains");
        CHECK(!run(workspace, "train.tb450"));
        REQUIRE(session.model().moving_loads.trains.size() == 1);
        CHECK(train(workspace).name == "TB-450");
        CHECK(sum(workspace) == Approx(train(workspace).placing.value).epsilon(1e-9));
        CHECK(run(workspace, "train.turn") == "the train runs in one direction alone");
        CHECK(!run(workspace, "train.tb450"));
        CHECK(session.model().moving_loads.trains.size() == 1);
        session.undo();
        CHECK(session.model().moving_loads.trains.empty());
        CHECK(picture(workspace) != nullptr);
        CHECK(session.influence.standing() == nullptr);
    }

    TEST_CASE("A train that is undone or deleted is chosen no longer, and is again where it comes back")
    {
        Workspace workspace = bridge();
        Session& session = workspace.session;
        CHECK(chosen_train(session).empty());
        CHECK(!run(workspace, "train.tb450"));
        CHECK(chosen_train(session) == "TB-450");
        session.undo();
        CHECK(chosen_train(session).empty());
        session.redo();
        CHECK(chosen_train(session) == "TB-450");
        workspace.trains.open(session);
        workspace.trains.erase(session);
        workspace.trains.accept(session);
        CHECK(chosen_train(session) != "TB-450");
    }

    TEST_CASE("Every train of the library can be taken, and stands on a beam")
    {
        Workspace workspace = bridge();
        CHECK(library_commands().size() == femoop::influence::train_library().size());
        for (const LibraryCommand& entry : library_commands()) {
            CAPTURE(entry.id);
            CHECK(!run(workspace, entry.id));
            CHECK(train(workspace).name == entry.train->name);
            CHECK(sum(workspace) == Approx(train(workspace).placing.value).epsilon(1e-9));
        }
    }

    TEST_CASE("In the envelope of a train the one that governs stands at its worst, and with what stays it is the band")
    {
        Workspace workspace = workspace_with("bridge.json");
        Session& session = workspace.session;
        CHECK(run(workspace, "train.envelope.with") == "no envelope of trains is shown; press Shift+E");
        CHECK(!run(workspace, "train.envelope"));
        CHECK(!run(workspace, "train.envelope.with"));
        const AskedEnvelope& envelope = session.train_envelope;
        REQUIRE(envelope.picture(session.model(), session.generation(), session.view) != nullptr);
        const drawing::Cut cut{MemberId(1), 20.0};
        const femoop::influence::TrainEffect moment = envelope.at(cut).back();
        ask_governing(workspace, moment.effect);
        CHECK(train(workspace).name == "HS20");
        CHECK(train(workspace).is_worst);
        CHECK(std::abs(moment.max.value) >= std::abs(moment.min.value));
        const double stays = -707.7777777778 + 1.4 * 40.0 * 20.0 - 0.5 * 1.4 * 20.0 * 20.0; // M(B) + V x - q x^2 / 2
        CHECK(stays + train(workspace).placing.value == Approx(moment.max.value).epsilon(1e-9));
        CHECK(!run(workspace, "edit.deselect"));
        CHECK(picture(workspace) == nullptr);
        CHECK(session.shows_train_envelope());
        ask_governing(workspace, moment.effect);
        REQUIRE(picture(workspace) != nullptr);
        CHECK(!run(workspace, "train.envelope")); // behind the line it comes back, and goes when it is seen
        CHECK(picture(workspace) == nullptr);
        CHECK(session.shows_train_envelope());
        CHECK(!run(workspace, "train.envelope"));
        CHECK(!session.view.is_envelope);
    }

    TEST_CASE("The envelope of trains goes when its last train does, and a case that is gone stays no more")
    {
        Workspace workspace = workspace_with("bridge.json");
        Session& session = workspace.session;
        CHECK(!run(workspace, "train.envelope"));
        CHECK(!run(workspace, "train.envelope.with"));
        CHECK(session.train_envelope.envelope(session.model()).with.has_value());
        session.change({"None", [](Document& document) {
                            document.model.moving_loads.envelopes.clear();
                            document.model.load_cases.clear();
                            document.model.expected.clear();
                        }});
        CHECK(!session.train_envelope.envelope(session.model()).with.has_value());
        CHECK(session.train_envelope.picture(session.model(), session.generation(), session.view) != nullptr);
        session.change({"None", [](Document& document) { document.model.moving_loads.trains.clear(); }});
        CHECK(!session.shows_train_envelope());
    }

    TEST_CASE("A train of forces beyond every number leaves the line alone, which says why")
    {
        Workspace workspace = bridge();
        Session& session = workspace.session;
        session.change({"Heavy", [](Document& document) {
                            document.model.moving_loads.trains[0].axles[0] = femoop::Quantity(1e300);
                        }});
        CHECK(!run(workspace, "train.next"));
        REQUIRE(picture(workspace) != nullptr);
        CHECK(session.influence.standing() == nullptr);
        CHECK(picture(workspace)->sentences.size() == 2);
        CHECK(run(workspace, "train.worst") ==
              "no train stands on the influence line; press R or take one from the menu Trains");
    }
}
