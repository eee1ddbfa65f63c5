#include "femoop/model/memory_footprint.h"

#include <doctest/doctest.h>

#include <cstddef>
#include <string>
#include <utility>

using namespace femoop;

namespace {

/// A beam of so many members.
Model beam(std::size_t n_members)
{
    Model model;
    for (std::size_t i = 0; i <= n_members; ++i) model.add(Node{.id = std::to_string(i)});
    for (std::size_t i = 0; i < n_members; ++i) {
        Member member;
        member.id = std::to_string(i);
        model.add(member);
    }
    return model;
}

} // namespace

TEST_SUITE("femoop model")
{
    TEST_CASE("A model takes memory in proportion to its members, and never less than they alone")
    {
        const std::size_t hundred = memory_footprint(beam(100)), thousand = memory_footprint(beam(1000));
        CHECK(hundred > 100 * (sizeof(Node) + sizeof(Member)));
        CHECK(static_cast<double>(thousand) == doctest::Approx(10.0 * static_cast<double>(hundred)).epsilon(0.05));
    }

    TEST_CASE("Loads, combinations and blocks of other programs count in the memory of a model")
    {
        Model model = beam(3);
        std::size_t before = memory_footprint(model);
        const auto grows = [&] { return memory_footprint(model) > std::exchange(before, memory_footprint(model)); };
        model.load_cases.emplace_back();
        CHECK(grows());
        model.load_cases[0].members.emplace_back();
        CHECK(grows());
        model.load_cases[0].nodes.emplace_back();
        CHECK(grows());
        model.combinations.emplace_back();
        CHECK(grows());
        model.extra.push_back({.key = "cross", .json = std::string(500, ' ')});
        CHECK(grows());
    }
}
