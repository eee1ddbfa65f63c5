#include "apps/plane/discretize/following_mesh.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "apps/plane/discretize/meshed_drawing.h"
#include "femoop/io/plane/plane_file.h"
#include "femoop/plane/analysis/plane_analysis.h"
#include "femoop/plane/mesh/mesh_quality.h"

using namespace femoop::plane;
using discretize::Drawing;
using discretize::FollowingMesh;
using discretize::MeshedDrawing;
using doctest::Approx;
using femoop::CaseId;

namespace {

/// A quarter of a plate with a hole of a radius about O, drawn to the right.
std::string quarter(double radius, const std::string& mesh = R"({"element": "T6", "size": 0.5})",
                    const std::string& more = "")
{
    const std::string r = std::to_string(radius);
    return R"({"cremona": 1, "analysis": "plane_stress", "units": {"length": "m", "force": "N"},
        "materials": [{"id": "m", "E": 300, "nu": 0.2}], "mesh": )" +
           mesh + R"(, "points": [{"id": "O", "at": [0, 0]}, {"id": "A", "at": [)" + r +
           R"(, 0]}, {"id": "B", "at": [4, 0]}, {"id": "C", "at": [4, 4]}, {"id": "D", "at": [0, 4]}, {"id": "E", "at": [0, )" +
           r +
           R"(]}], "curves": [{"id": "bottom", "kind": "line", "points": ["A", "B"], "support": "symmetry"},
            {"id": "right", "kind": "line", "points": ["B", "C"]}, {"id": "top", "kind": "line", "points": ["C", "D"]},
            {"id": "left", "kind": "line", "points": ["D", "E"], "support": "symmetry"},
            {"id": "hole", "kind": "arc", "center": "O", "points": ["E", "A"], "turn": "cw"})" +
           more + R"(], "regions": [{"id": "plate", "at": [3, 3], "material": "m", "thickness": 1}],
            "load_cases": [{"id": "P", "curves": [{"curve": "right", "kind": "traction", "qx": 3}]}]})";
}

/// Keeps its model, which the drawing refers to.
struct Drawn {
    explicit Drawn(const std::string& text) : model(examine_plane_model(text).model), drawing(model) {}
    Drawn(const Drawn&) = delete;
    Drawn& operator=(const Drawn&) = delete;

    PlaneModel model;
    Drawing drawing;
};

double area(const PlaneModel& mesh)
{
    double sum = 0.0;
    for (const RegionSize& size : region_sizes(mesh)) sum += size.area;
    return sum;
}

} // namespace

TEST_CASE("A mesh goes along with its drawing: the elements stay, and what they fill is the new drawing")
{
    for (const std::string& mesh :
         {std::string(R"({"element": "T6", "size": 0.5})"), std::string(R"({"element": "T3", "size": 0.4})"),
          std::string(R"({"element": "Q9", "size": 0.5, "method": "quads"})"),
          std::string(R"({"element": "Q8", "size": 0.5, "method": "quads"})")}) {
        CAPTURE(mesh);
        const Drawn small(quarter(1.0, mesh)), large(quarter(1.5, mesh));
        const MeshedDrawing before(small.drawing), anew(large.drawing);
        REQUIRE(before.is_sound());
        auto moved = FollowingMesh(small.drawing, before.mesh()).in(large.drawing);
        REQUIRE(moved);
        const MeshedDrawing after(large.drawing, *moved);
        REQUIRE(after.is_sound());
        CHECK(after.model().elements == before.model().elements);
        CHECK(after.model().curves == before.model().curves);
        CHECK(area(after.model()) == Approx(area(anew.model())).epsilon(0.01));
        for (const femoop::NodeId node : after.model().curves[4].points) {
            const auto& [x, y] = after.model()[node].at;
            CHECK(std::hypot(x, y) == Approx(1.5));
        }
        const PlaneResults results = analyse(after.model());
        CHECK(results[CaseId(0)].equilibrium().sum_reactions[0] == Approx(-12.0));
    }
}

TEST_CASE("A drawing that comes back has its mesh again")
{
    const Drawn drawn(quarter(1.0));
    const MeshedDrawing before(drawn.drawing);
    const auto same = FollowingMesh(drawn.drawing, before.mesh()).in(drawn.drawing);
    REQUIRE(same);
    for (std::size_t i = 0; i < same->nodes.size(); ++i) {
        CHECK(same->nodes[i].x == Approx(before.mesh().nodes[i].x));
        CHECK(same->nodes[i].y == Approx(before.mesh().nodes[i].y));
    }
}

TEST_CASE("No mesh goes along where curves meet otherwise, or are to be divided otherwise")
{
    const Drawn drawn(quarter(1.0));
    const MeshedDrawing before(drawn.drawing);
    const FollowingMesh mesh(drawn.drawing, before.mesh());
    CHECK(!mesh.in(Drawn(quarter(1.0, R"({"element": "T6", "size": 0.5})",
                                 R"(, {"id": "cut", "kind": "line", "points": [[2, -1], [2, 5]]})"))
                       .drawing));
    CHECK(!mesh.in(Drawn(quarter(1.0, R"({"element": "T6", "size": 0.25})")).drawing));
    CHECK(!mesh.in(Drawn(quarter(1.0, R"({"element": "Q8", "size": 0.5})")).drawing));
}
