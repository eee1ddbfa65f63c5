#include <doctest/doctest.h>

#include <set>
#include <string>
#include <vector>

#include "femoop/methods/counting/rings.h"
#include "tests/frame_maker.h"

using namespace femoop;
using counting::Ring;

namespace {

std::set<std::string> names(const Ring& ring, const Model& model)
{
    std::set<std::string> names;
    for (const MemberId member : ring.members) names.insert(model[member].id);
    return names;
}

std::vector<Ring> rings_of(const Model& model) { return counting::rings(discretise(model)); }

/// A square of side 4 whose diagonals cross without a node.
FrameMaker crossed_square()
{
    FrameMaker made;
    made.node("A", 0, 0).node("B", 4, 0).node("C", 4, 4).node("D", 0, 4);
    made.member("A", "B").member("B", "C").member("C", "D").member("D", "A").member("A", "C").member("B", "D");
    return made;
}

} // namespace

TEST_CASE("The rings of a storey frame are its meshes, from below to above and from left to right")
{
    Model model = storey_frame(3, 4);
    const std::vector<Ring> rings = rings_of(model);
    REQUIRE(rings.size() == 9); // the lowest storey stands on the ground
    for (const Ring& ring : rings) CHECK(ring.members.size() == 4);
    CHECK(rings[0].middle.isApprox(Eigen::Vector3d(3.0, 1.5 * 3.5, 0.0)));
    CHECK(rings[1].middle.isApprox(Eigen::Vector3d(9.0, 1.5 * 3.5, 0.0)));
    CHECK(rings[3].middle.isApprox(Eigen::Vector3d(3.0, 2.5 * 3.5, 0.0)));
}

TEST_CASE("What hangs in a mesh belongs to no ring")
{
    FrameMaker made;
    made.node("A", 0, 0).node("B", 4, 0).node("C", 4, 3).node("D", 0, 3).node("E", 1, 1);
    made.member("A", "B").member("B", "C").member("C", "D").member("D", "A").member("A", "E");
    const std::vector<Ring> rings = rings_of(made.model);
    REQUIRE(rings.size() == 1);
    CHECK(names(rings[0], made.model) == std::set<std::string>{"AB", "BC", "CD", "DA"});
}

TEST_CASE("The label of a bent mesh stands within it")
{
    FrameMaker made; // an L of limbs so thin that its centroid lies outside
    made.node("A", 0, 0).node("B", 9, 0).node("C", 9, 1).node("D", 1, 1).node("E", 1, 9).node("F", 0, 9);
    made.member("A", "B").member("B", "C").member("C", "D").member("D", "E").member("E", "F").member("F", "A");
    const std::vector<Ring> rings = rings_of(made.model);
    REQUIRE(rings.size() == 1);
    CHECK(rings[0].middle.x() > 0.0);
    CHECK(rings[0].middle.x() < 1.0);
}

TEST_CASE("Members that cross without a node make three short rings")
{
    const std::vector<Ring> rings = rings_of(crossed_square().model);
    REQUIRE(rings.size() == 3);
    for (const Ring& ring : rings) CHECK(ring.members.size() == 3);
}

TEST_CASE("Two members between the same nodes are a ring")
{
    FrameMaker made;
    made.node("A", 0, 0).node("B", 4, 0).member("A", "B").member("A", "B", "+");
    const std::vector<Ring> rings = rings_of(made.model);
    REQUIRE(rings.size() == 1);
    CHECK(names(rings[0], made.model) == std::set<std::string>{"AB", "A+B"});
}

TEST_CASE("A cube of members has five rings of four")
{
    FrameMaker made;
    made.model.analysis = AnalysisKind::Frame3d;
    for (int i = 0; i < 8; ++i)
        made.model.add(Node{.id = std::to_string(i), .at = {3.0 * (i & 1), 4.0 * ((i >> 1) & 1), 5.0 * (i >> 2)}});
    for (int i = 0; i < 8; ++i)
        for (const int bit : {1, 2, 4})
            if ((i & bit) == 0) made.member(std::to_string(i), std::to_string(i | bit), "-");
    const std::vector<Ring> rings = rings_of(made.model);
    REQUIRE(rings.size() == 5);
    for (const Ring& ring : rings) CHECK(ring.members.size() == 4);
}
