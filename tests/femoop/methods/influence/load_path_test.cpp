#include <doctest/doctest.h>

#include "femoop/geometry/path_walk.h"
#include "femoop/methods/influence/load_path.h"
#include "tests/frame_maker.h"

using namespace femoop;
using namespace femoop::influence;

namespace {

/// A - B - C - D in a line, BC drawn from C to B.
Model deck()
{
    FrameMaker made;
    made.node("A", 0, 0, SupportKind::Pin).node("B", 3, 0, SupportKind::Roller).node("C", 7, 0, SupportKind::Roller);
    made.node("D", 12, 0, SupportKind::Roller);
    made.member("A", "B").member("C", "B").member("C", "D");
    return made.model;
}

std::vector<MemberId> named(const Model& model, const std::vector<std::string>& names)
{
    std::vector<MemberId> members;
    for (const std::string& name : names) members.push_back(*model.find_member(name));
    return members;
}

} // namespace

TEST_CASE("A path passes members whatever their own direction")
{
    const Model model = deck();
    const PathLayout path = lay_out(model, named(model, {"AB", "CB", "CD"}));
    CHECK(path.length() == doctest::Approx(12.0));
    CHECK(path.members[1].is_reversed);
    const PathPlace place = path.place(4.0);
    CHECK(place.member == *model.find_member("CB"));
    CHECK(place.x == doctest::Approx(3.0)); // 1 beyond B, and CB begins at C, 4 from B
    CHECK(path.nodes() == std::vector<double>{0.0, 3.0, 7.0, 12.0});
}

TEST_CASE("A path begins at the end of its first member that the second does not touch")
{
    const Model model = deck();
    const PathLayout path = lay_out(model, named(model, {"CD", "CB"}));
    CHECK(path.members[0].is_reversed); // from D
    CHECK(path.place(5.0, Side::Before).x == doctest::Approx(0.0));
    CHECK(path.place(5.0, Side::After).member == *model.find_member("CB"));
    const PathLayout single = lay_out(model, named(model, {"CB"}));
    CHECK_FALSE(single.members[0].is_reversed);
}

TEST_CASE("Only the flexible parts of members count on a path")
{
    Model model = deck();
    model.members[1].start.offset = {-0.5, 0.0};
    const PathLayout path = lay_out(model, named(model, {"AB", "CB", "CD"}));
    CHECK(path.length() == doctest::Approx(11.5));
}

TEST_CASE("Members that do not follow one another are named with their ends")
{
    const Model model = deck();
    const auto fault = why_no_path(model, named(model, {"AB", "CD"}), "paths[0] \"deck\"");
    REQUIRE(fault);
    CHECK(message(*fault) == "paths[0] \"deck\": member \"CD\" (C - D) does not begin where member \"AB\" (A - B) "
                             "ends; name members that follow one another, node by node");
    CHECK(why_no_path(model, {}, "x")->kind == FaultKind::PathWithoutMembers);
    CHECK(why_no_path(model, named(model, {"AB", "AB"}), "x")->kind == FaultKind::PathBroken);
    CHECK_FALSE(why_no_path(model, named(model, {"AB", "CB", "CD"}), "x"));
}

TEST_CASE("A place on a member is found again along the path")
{
    const Model model = deck();
    const PathLayout path = lay_out(model, named(model, {"AB", "CB", "CD"}));
    CHECK(path.places_of(*model.find_member("CB"), 3.0) == std::vector<double>{4.0});
}
