// How far a sheet is worked: turns, back and forward, branches.
#include <doctest/doctest.h>

#include "apps/cross/document/play.h"

using namespace cross;
using femoop::cross::JointId;

namespace {

constexpr JointId B{std::size_t{0}}, C{std::size_t{1}}, D{std::size_t{2}};

Play played(const std::vector<Play::Turn>& turns)
{
    Play play;
    for (const Play::Turn& turn : turns) play.take(turn);
    return play;
}

} // namespace

TEST_CASE("Turns are kept in the order in which they were taken")
{
    CHECK(played({C, B, {}, C}).turns() == std::vector<Play::Turn>{C, B, {}, C});
}

TEST_CASE("Back and forward again is where one was")
{
    Play play = played({C, B, D});
    play.back();
    play.back();
    CHECK(play.turns() == std::vector<Play::Turn>{C});
    CHECK(play.n_ahead() == 2);
    CHECK(play.forward());
    CHECK(play.forward());
    CHECK_FALSE(play.forward());
    CHECK(play.turns() == std::vector<Play::Turn>{C, B, D});
}

TEST_CASE("Another turn after going back keeps the branch that was left")
{
    Play play = played({C, B});
    play.back();
    play.take(D);
    REQUIRE(play.branches().size() == 2);
    CHECK(play.turns() == std::vector<Play::Turn>{C, D});
    play.go_to(play.branches().front());
    CHECK(play.turns() == std::vector<Play::Turn>{C, B});
    play.restart();
    play.jump(2);
    CHECK(play.turns() == std::vector<Play::Turn>{C, B}); // the way that was gone last
}

TEST_CASE("The same turn again after going back is no new branch")
{
    Play play = played({C, B});
    play.back();
    play.take(B);
    CHECK(play.branches().size() == 1);
}

TEST_CASE("A jump goes no farther than the turns that there are")
{
    Play play = played({C, B, D});
    play.jump(1);
    CHECK(play.length() == 1);
    play.jump(99);
    CHECK(play.length() == 3);
}
