#include "femoop/methods/free_body/ritter.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "femoop/analysis/linear_static.h"
#include "femoop/io/free_body/free_body_text.h"
#include "femoop/io/model_file.h"
#include "tests/frame_maker.h"

using namespace femoop;
using namespace femoop::free_body;

namespace {

/// What lies beside a node of members that are cut in their middles.
FreeBody beside(const Model& model, const std::string& node, const std::vector<std::string>& members)
{
    const Discretisation structure = discretise(model);
    std::vector<Cut> cuts;
    for (const std::string& name : members) {
        const MemberId member = *model.find_member(name);
        cuts.push_back({member, 0.5 * structure.geometry(member).length});
    }
    const std::vector<NodeId> nodes{*model.find_node(node)};
    return lift_out(model, analyse(model), CaseId(0), body_of(structure, cuts, nodes));
}

} // namespace

TEST_SUITE("free body")
{
    TEST_CASE("About the point in which two of three cut bars meet the third has the force of textbooks")
    {
        const Model model = read_model_file("examples/pratt_truss.json"); // 5 P of 30, panels of 3, height 4
        const FreeBody left = beside(model, "L0", {"L2L3", "U2L3", "U2U3"});
        const std::vector<RitterPoint>& points = left.ritter_points;
        REQUIRE(points.size() == 2); // the chords are parallel: the diagonal has none
        for (const RitterPoint& point : points) {
            const bool is_lower = model[point.bar].id == "L2L3";
            CHECK((point.at - (is_lower ? Eigen::Vector3d(6, 4, 0) : Eigen::Vector3d(9, 0, 0))).norm() < 1e-12);
            const double wanted = is_lower ? (75.0 * 6 - 30 * 3) / 4 : -(75.0 * 9 - 30 * 6 - 30 * 3) / 4;
            CHECK(ritter_force(left, point).force == doctest::Approx(wanted).epsilon(1e-12));
        }
        CHECK(ritter_lines(left, model, points.front(), english) ==
              std::vector<std::string>{"N of L2L3 = (75 kN · 6 m − 30 kN · 3 m) / 4 m",
                                       "= (450 − 90) / 4 = 90  [kN]  about (6, 4), where the other bars meet"});
        CHECK(usual_moment_point(left, model) == points.front().at);
    }

    TEST_CASE("Both sides of a cut give one force")
    {
        const Model model = read_model_file("examples/pratt_truss.json");
        const FreeBody left = beside(model, "L0", {"L2L3", "U2L3", "U2U3"});
        const FreeBody right = beside(model, "L6", {"L2L3", "U2L3", "U2U3"});
        for (const RitterPoint& a : left.ritter_points)
            for (const RitterPoint& b : right.ritter_points)
                if (a.bar == b.bar)
                    CHECK(ritter_force(left, a).force == doctest::Approx(ritter_force(right, b).force).epsilon(1e-12));
    }

    TEST_CASE("A cut through a beam, or through two bars, has no Ritter point")
    {
        FrameMaker made;
        made.node("A", 0, 0, SupportKind::Fixed).node("B", 3, 0).node("C", 3, 4).node("D", 0, 4, SupportKind::Fixed);
        made.member("A", "B").member("D", "C").member("A", "C").member("B", "C").force("C", Dof::uy, -10.0);
        CHECK(beside(made.model, "C", {"AB", "DC", "AC"}).ritter_points.empty());
        const Model truss = read_model_file("examples/pratt_truss.json");
        CHECK(beside(truss, "L0", {"L0U1", "L0L1"}).ritter_points.empty());
    }
}
