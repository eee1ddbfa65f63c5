// Refinement by the error, without a screen.
#include "apps/plane/discretize/error_cycle.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "apps/plane/discretize/meshed_drawing.h"
#include "femoop/io/plane/plane_file.h"
#include "femoop/plane/analysis/plane_analysis.h"
#include "tests/text_of.h"

using namespace femoop::plane;
using discretize::Drawing;
using discretize::ErrorCycle;
using discretize::MeshedDrawing;

namespace {

/// A bracket with a re-entrant corner at (50, 50), held above and sheared at its right end.
std::string bracket(const std::string& element)
{
    return R"({"cremona": 1, "analysis": "plane_stress", "units": {"length": "mm", "force": "N"},
      "mesh": {"element": ")" +
           element + R"(", "size": 15}, "materials": [{"id": "steel", "E": "200 GPa", "nu": 0.3}],
      "curves": [{"id": "outline", "kind": "line", "closed": true,
                  "points": [[0, 0], [100, 0], [100, 50], [50, 50], [50, 100], [0, 100]]},
                 {"id": "top", "kind": "line", "points": [[0, 100], [50, 100]], "support": "fixed"},
                 {"id": "end", "kind": "line", "points": [[100, 0], [100, 50]]}],
      "regions": [{"id": "bracket", "at": [20, 20], "material": "steel", "thickness": 5}],
      "load_cases": [{"id": "P", "curves": [{"curve": "end", "kind": "traction", "qy": -10}]}]})";
}

/// A drawing whose mesh goes through cycles until they end.
struct Cycled {
    Cycled(const std::string& text, std::size_t n_cycles, std::size_t most_unknowns = 50'000)
        : model(read_plane_model(text)), drawing(model), cycle({}, most_unknowns)
    {
        add(MeshedDrawing(drawing));
        for (std::size_t i = 0; i < n_cycles; ++i) {
            next = cycle.next();
            if (next.end) return;
            cycle.take(next.sizes);
            add(MeshedDrawing(drawing, {}, next.sizes));
            // predicted before it is made
            CHECK(static_cast<double>(cycle.meshes().back().n_unknowns) < 1.6 * next.n_unknowns);
            CHECK(static_cast<double>(cycle.meshes().back().n_unknowns) > 0.6 * next.n_unknowns);
        }
    }
    void add(const MeshedDrawing& mesh)
    {
        REQUIRE(mesh.is_sound());
        const PlaneResults results = analyse(mesh.model());
        cycle.add(results, results[femoop::CaseId{}]);
    }

    PlaneModel model;
    Drawing drawing;
    ErrorCycle cycle;
    discretize::NextMesh next;
};

} // namespace

TEST_CASE("Beside a corner the error of meshes refined by it falls as smooth stresses would, of even ones with N^-0.27")
{
    for (const std::string element : {"T3", "T6", "Q8"}) {
        CAPTURE(element);
        Cycled cycled(bracket(element), element == "T3" ? 5 : 8);
        cycled.cycle.compare(cycled.drawing);
        const double smooth = cycled.cycle.smooth_rate();
        CHECK(smooth == (element == "T3" ? 0.5 : 1.0));
        // from the first mesh to the last: one alone may be worse or better than its sizes
        const discretize::MeshError first = cycled.cycle.meshes().front(), last = cycled.cycle.meshes().back();
        const double spread = static_cast<double>(last.n_unknowns) / static_cast<double>(first.n_unknowns);
        CHECK(std::log(first.error / last.error) / std::log(spread) > 0.75 * smooth);
        REQUIRE(cycled.cycle.uniform().size() > 2);
        // at a corner of 270 degrees displacements go with r^x, sin(1.5 pi x) = x; so the error with h^x
        const double of_corner = 0.5 * 0.5445;
        CHECK(*rate(cycled.cycle.uniform()) < 1.5 * of_corner);
        CHECK(*rate(cycled.cycle.uniform()) > 0.6 * of_corner);
        if (element == "T3") continue; // half of its smooth rate is near to that of the corner
        const auto place = cycled.cycle.singular_place();
        REQUIRE(place);
        CHECK((place->at - Eigen::Vector2d(50.0, 50.0)).norm() < 1e-3 * 100.0); // of the side of the bracket
        CHECK(place->size < 1e-2 * 15.0);                                       // of the first mesh
    }
}

TEST_CASE("A hole's stresses are smooth: no place is called singular, and sizes gather at the hole")
{
    Cycled cycled(text_of_source("examples/hole.json"), 4);
    cycled.cycle.compare(cycled.drawing);
    CHECK_FALSE(cycled.cycle.singular_place());
    const auto& sizes = *cycled.cycle.sizes();
    CHECK(sizes.at({0.0, 10.0}) < 0.1 * sizes.at({200.0, 200.0}));
    CHECK(cycled.cycle.meshes().back().error < cycled.cycle.meshes().front().error / 10.0);
}

TEST_CASE("A cycle ends before a mesh that is too large, and where the error is rounding")
{
    const Cycled large(bracket("T3"), 8, 3000);
    CHECK(large.next.end == discretize::CycleEnd::TooLarge);
    CHECK(large.next.n_unknowns > 3000.0);
    CHECK(large.next.sizes == nullptr);
    for (const auto& mesh : large.cycle.meshes()) CHECK(mesh.n_unknowns < 3000);
    // a strip that is pulled evenly is solved exactly by any mesh
    const Cycled exact(R"({"cremona": 1, "analysis": "plane_stress", "units": {"length": "mm", "force": "N"},
      "mesh": {"element": "T3", "size": 20}, "materials": [{"id": "steel", "E": "200 GPa", "nu": 0.3}],
      "points": [{"id": "A", "at": [0, 0], "support": {"fixed": ["uy"]}}],
      "curves": [{"id": "left", "kind": "line", "points": [[0, 50], "A"], "support": "symmetry"},
                 {"id": "rest", "kind": "line", "points": ["A", [90, 0]]},
                 {"id": "end", "kind": "line", "points": [[90, 0], [90, 50]]},
                 {"id": "above", "kind": "line", "points": [[90, 50], [0, 50]]}],
      "regions": [{"id": "strip", "at": [20, 20], "material": "steel", "thickness": 5}],
      "load_cases": [{"id": "P", "curves": [{"curve": "end", "kind": "traction", "qx": 30}]}]})",
                       3);
    CHECK(exact.next.end == discretize::CycleEnd::Exact);
    CHECK(exact.cycle.meshes().size() == 1);
}

TEST_CASE("A region that asks to be mapped is not refined, one that is mapped of itself is meshed freely then")
{
    const PlaneModel mapped = read_plane_model(text_of_source("examples/locking.json"));
    REQUIRE(discretize::mapped_region(mapped));
    CHECK(mapped[*discretize::mapped_region(mapped)].id == "strip");
    CHECK_FALSE(discretize::mapped_region(read_plane_model(text_of_source("examples/plate.json"))));
    Cycled cycled(text_of_source("examples/plate.json"), 1);
    CHECK(MeshedDrawing(cycled.drawing).reports()[0].method == "mapped");
    CHECK(MeshedDrawing(cycled.drawing, {}, cycled.cycle.sizes()).reports()[0].method == "delaunay");
}
