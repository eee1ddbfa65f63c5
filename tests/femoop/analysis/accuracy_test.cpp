#include <doctest/doctest.h>

#include "femoop/analysis/accuracy.h"

using namespace femoop;

namespace {

/// One load case whose worst unknown lacks so much of a load of 1, beside a reaction.
detail::Solution lacking(double force, double reaction)
{
    detail::Solution solution;
    detail::CaseSolution one;
    one.balance = {.out_of_balance = force, .imposed = 1.0, .largest = reaction, .sum_forces = 2.0 * reaction};
    one.equilibrium.residual = force;
    solution.solutions.push_back(one);
    solution.cases.emplace_back().name = "P";
    return solution;
}

} // namespace

TEST_SUITE("analysis")
{
    TEST_CASE("A force out of balance that is told as more than 1e-8 of the load is warned of, whatever the reactions")
    {
        for (const double reaction : {1.0, 1e3, 1e6}) {
            CAPTURE(reaction);
            CHECK(inaccurate_cases(lacking(0.9e-8, reaction)).empty());
            const auto faults = inaccurate_cases(lacking(1.1e-8, reaction));
            REQUIRE(faults.size() == 1);
            CHECK(faults.front().kind == FaultKind::InaccurateCase);
            CHECK(faults.front().arguments == std::vector<std::string>{"P", "7"});
            CHECK(ill_conditioned_cases(lacking(1.1e-8, reaction)).empty());
        }
    }
}
