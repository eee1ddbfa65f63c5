#include "apps/plane/discretize/mesh_player.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "apps/plane/discretize/meshed_drawing.h"
#include "femoop/io/plane/plane_file.h"

using discretize::Drawing;
using discretize::MeshPlayer;
using topology::MeshStep;

namespace {

/// Two squares side by side; the right one is meshed by another method.
std::string two_squares(const std::string& left, const std::string& right)
{
    const auto region = [](const std::string& id, const std::string& at, const std::string& mesh) {
        return R"({"id": ")" + id + R"(", "at": )" + at + R"(, "material": "m", "thickness": 1, "mesh": )" + mesh + "}";
    };
    return R"({"cremona": 1, "analysis": "plane_stress", "units": {"length": "m", "force": "N"},
        "materials": [{"id": "m", "E": 300, "nu": 0.2}], "mesh": {"size": 0.35}, "curves": [
        {"id": "outline", "kind": "line", "closed": true, "points": [[0, 0], [2, 0], [4, 0], [4, 2], [2, 2], [0, 2]]},
        {"id": "middle", "kind": "line", "points": [[2, 0], [2, 2]]}], "regions": [)" +
           region("left", "[1, 1]", left) + ", " + region("right", "[3, 1]", right) + "]}";
}

std::size_t n_cells(const MeshPlayer& player)
{
    std::size_t n = 0;
    for (const topology::CellMesh& mesh : player.meshes()) n += mesh.cells.size();
    return n;
}

} // namespace

TEST_CASE("The last step of every mesher stands where the mesh of the drawing does, and each step can be gone back to")
{
    for (const char* const method : {"mapped", "sweep", "delaunay", "front", "quadtree", "quads"}) {
        CAPTURE(method);
        const std::string element = std::string(method) == "quads" ? "Q4" : "T3";
        const auto reading = femoop::plane::examine_plane_model(
            two_squares(R"({"element": ")" + element + R"(", "method": ")" + method + R"("})",
                        R"({"element": ")" + element + R"("})"));
        const Drawing drawing(reading.model);
        const discretize::MeshedDrawing mesh(drawing);
        REQUIRE(mesh.is_sound());
        MeshPlayer player(drawing);
        CHECK(player.place() == 0);
        CHECK(!player.step().has_value());
        player.go_to(player.n_steps());
        CHECK(n_cells(player) == mesh.model().elements.size());
        const std::size_t half = player.n_steps() / 2;
        player.go_to(half);
        const std::size_t there = n_cells(player);
        player.go_to(half + 3);
        player.go_to(half);
        CHECK(player.place() == half);
        CHECK(n_cells(player) == there);
        player.go_to(player.n_steps() + 100);
        CHECK(player.place() == player.n_steps());
    }
}

TEST_CASE("A player walks through one region after the other, and says by which method each is meshed")
{
    const auto reading = femoop::plane::examine_plane_model(
        two_squares(R"({"element": "Q4", "method": "mapped"})", R"({"element": "Q4", "method": "quads"})"));
    const Drawing drawing(reading.model);
    MeshPlayer player(drawing);
    player.go_to(1);
    CHECK(player.method() == "mapped");
    CHECK(player.step() == MeshStep::Row);
    CHECK(player.region().index == 0);
    player.go_to(player.n_steps());
    CHECK(player.method() == "quads");
    CHECK(player.region().index == 1);
}
