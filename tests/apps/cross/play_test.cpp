// How far a sheet is worked: turns, back and forward, branches.
#include <doctest/doctest.h>

#include "apps/cross/document/turn_tree.h"

using namespace cross;
using femoop::cross::JointId;

namespace {

constexpr JointId B{std::size_t{0}}, C{std::size_t{1}}, D{std::size_t{2}};

TurnTree played(const std::vector<TurnTree::Turn>& turns)
{
    TurnTree turn_tree;
    for (const TurnTree::Turn& turn : turns) turn_tree.advance(turn);
    return turn_tree;
}

} // namespace

TEST_CASE("Turns are kept in the order in which they were taken")
{
    CHECK(played({C, B, {}, C}).turns() == std::vector<TurnTree::Turn>{C, B, {}, C});
}

TEST_CASE("Back and forward again is where one was")
{
    TurnTree turn_tree = played({C, B, D});
    turn_tree.back();
    turn_tree.back();
    CHECK(turn_tree.turns() == std::vector<TurnTree::Turn>{C});
    CHECK(turn_tree.n_ahead() == 2);
    CHECK(turn_tree.forward());
    CHECK(turn_tree.forward());
    CHECK_FALSE(turn_tree.forward());
    CHECK(turn_tree.turns() == std::vector<TurnTree::Turn>{C, B, D});
}

TEST_CASE("Another turn after going back keeps the branch that was left")
{
    TurnTree turn_tree = played({C, B});
    turn_tree.back();
    turn_tree.advance(D);
    REQUIRE(turn_tree.branches().size() == 2);
    CHECK(turn_tree.turns() == std::vector<TurnTree::Turn>{C, D});
    turn_tree.go_to(turn_tree.branches().front());
    CHECK(turn_tree.turns() == std::vector<TurnTree::Turn>{C, B});
    turn_tree.restart();
    turn_tree.jump(2);
    CHECK(turn_tree.turns() == std::vector<TurnTree::Turn>{C, B}); // the way that was gone last
}

TEST_CASE("The same turn again after going back is no new branch")
{
    TurnTree turn_tree = played({C, B});
    turn_tree.back();
    turn_tree.advance(B);
    CHECK(turn_tree.branches().size() == 1);
}

TEST_CASE("A jump goes no farther than the turns that there are")
{
    TurnTree turn_tree = played({C, B, D});
    turn_tree.jump(1);
    CHECK(turn_tree.length() == 1);
    turn_tree.jump(99);
    CHECK(turn_tree.length() == 3);
}
