#include "apps/frame/session/train_draft.h"

#include <doctest/doctest.h>

#include <vector>

#include "apps/frame/document/train_command.h"
#include "tests/apps/frame/example_workspace.h"

using namespace frame;
using doctest::Approx;
using femoop::Train;
using femoop::TrainId;
using frame_test::workspace_with;

namespace {

Train lorry()
{
    return {.id = "lorry", .path = femoop::PathId(0), .axles = {8.0, 32.0, 33.0, 21.0}, .spacings = {14.0, 15.0, 7.0}};
}

} // namespace

TEST_SUITE("frame session")
{
    TEST_CASE("A train of one's own begins with round numbers in any units")
    {
        const Train in_feet = usual_train({femoop::LengthUnit::ft, femoop::ForceUnit::kip}, femoop::PathId(0));
        CHECK(in_feet.axles.at(1) == 20.0);
        CHECK(in_feet.spacings.at(0) == 7.0);
        const Train in_metres = usual_train({femoop::LengthUnit::m, femoop::ForceUnit::kN}, femoop::PathId(0));
        CHECK(in_metres.axles.at(1) == 100.0);
        CHECK(in_metres.spacings.at(0) == 2.0);
    }

    TEST_CASE("An axle that is taken out leaves the others where they stand")
    {
        for (std::size_t axle = 1; axle < 4; ++axle) {
            CAPTURE(axle);
            Train train = lorry();
            erase_axle(train, axle);
            REQUIRE(train.axles.size() == 3);
            REQUIRE(train.spacings.size() == 2);
            for (std::size_t i = 0; i < 3; ++i)
                CHECK(place_of_axle(train, i) == Approx(place_of_axle(lorry(), i < axle ? i : i + 1)));
        }
        Train train = lorry();
        erase_axle(train, 0);
        CHECK(place_of_axle(train, 2) == Approx(22.0));
    }

    TEST_CASE("A distance that may vary goes along with its axles, and with the one that joins it")
    {
        Train train = lorry();
        set_longest_spacing(train, 1, femoop::Quantity(30.0));
        REQUIRE(spacing_range(train, 1));
        CHECK(spacing_range(train, 1)->min.value() == 15.0);
        Train without_first = train;
        erase_axle(without_first, 0);
        REQUIRE(spacing_range(without_first, 0));
        CHECK(spacing_range(without_first, 0)->max.value() == 30.0);
        erase_axle(train, 1);
        REQUIRE(spacing_range(train, 0));
        CHECK(spacing_range(train, 0)->min.value() == 29.0);
        CHECK(spacing_range(train, 0)->max.value() == 44.0);
        set_longest_spacing(train, 0, femoop::Quantity(29.0));
        CHECK(train.spacing_ranges.empty());
        CHECK(train.spacings[0].value() == 29.0);
    }

    TEST_CASE("An envelope goes on without a train that is deleted, and goes with its last one")
    {
        femoop::MovingLoads loads;
        loads.trains = {lorry(), lorry(), lorry()};
        loads.envelopes = {{.id = "all", .trains = {TrainId(0), TrainId(1), TrainId(2)}, .with = {}, .factor = 1.0},
                           {.id = "one", .trains = {TrainId(1)}, .with = {}, .factor = 1.0}};
        erase_train(loads, TrainId(1));
        REQUIRE(loads.envelopes.size() == 1);
        CHECK(loads.envelopes[0].trains == std::vector{TrainId(0), TrainId(1)});
    }

    TEST_CASE("All that is edited of the trains is one step, and giving it up leaves nothing behind")
    {
        Workspace workspace = workspace_with("bridge.json");
        Session& session = workspace.session;
        TrainDraft& draft = workspace.trains;
        const std::vector<Train> before = session.model().moving_loads.trains;
        draft.open(session);
        CHECK(!draft.run_command(session, "take", "HL-93 truck + lane"));
        CHECK(!draft.run_command(session, "axle", "1 10 kip"));
        CHECK(session.model().moving_loads.trains.size() == before.size() + 1);
        CHECK(draft.run_command(session, "axle", "4 10 kip") == "no axle \"4 10 kip\"");
        CHECK(draft.run_command(session, "distance", "1 -3 ft").has_value());
        CHECK(draft.run_command(session, "name", "HS20") == "there is another one named HS20");
        CHECK(!draft.run_command(session, "delete", ""));
        draft.cancel(session);
        CHECK(session.model().moving_loads.trains == before);
        draft.open(session);
        CHECK(!draft.run_command(session, "copy", ""));
        CHECK(!draft.run_command(session, "delete_axle", "2"));
        draft.accept(session);
        CHECK(session.model().moving_loads.trains.back().axles.size() == before.front().axles.size() - 1);
        session.undo();
        CHECK(session.model().moving_loads.trains == before);
    }

    TEST_CASE("A file that is dropped while trains are edited waits until that is done")
    {
        Workspace workspace = workspace_with("bridge.json");
        const std::string file = workspace.session.path()->string();
        workspace.trains.open(workspace.session);
        workspace.open_dropped({file});
        REQUIRE(workspace.session.notice);
        CHECK(workspace.session.notice->sentence.sentence == "finish what is being made in the window first");
        workspace.trains.cancel(workspace.session);
        CHECK(!workspace.has_open_draft());
    }

    TEST_CASE("A train keeps an axle or a uniform load")
    {
        Workspace workspace = workspace_with("portal.json");
        Session& session = workspace.session;
        TrainDraft& draft = workspace.trains;
        draft.open(session);
        CHECK(draft.run_command(session, "impact", "1.3") == "no train \"1.3\"");
        CHECK(!draft.run_command(session, "new", ""));
        REQUIRE(draft.trains().size() == 1);
        CHECK(!draft.run_command(session, "delete_axle", "1"));
        CHECK(draft.run_command(session, "delete_axle", "1").has_value());
        CHECK(draft.train().axles.size() == 1);
        CHECK(!draft.run_command(session, "uniform", "5 kN/m"));
        CHECK(!draft.run_command(session, "delete_axle", "1"));
        CHECK(draft.train().axles.empty());
        draft.accept(session);
        CHECK(!session.model().moving_loads.trains.empty());
    }
}
