#include "topology/meshing/triangulation.h"

#include <doctest/doctest.h>

#include <random>

#include "topology/geometry/predicates.h"

using namespace topology;

namespace {

using Index = Triangulation::Index;

void insert(Triangulation& triangles, const FlatPoint& at)
{
    REQUIRE(triangles.cavity(at, triangles.corner_of(static_cast<Index>(triangles.n_vertices() - 1)) / 3) != nullptr);
    triangles.insert(at);
}

Triangulation of_random_places(int n, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> whole(0, 40); // many on one line, many on one circle
    FlatBox box;
    box.add({0.0, 0.0});
    box.add({40.0, 40.0});
    Triangulation triangles(box);
    std::vector<FlatPoint> known;
    while (known.size() < static_cast<std::size_t>(n)) {
        const FlatPoint at{static_cast<double>(whole(random)), static_cast<double>(whole(random))};
        if (std::find(known.begin(), known.end(), at) != known.end()) continue;
        known.push_back(at);
        insert(triangles, at);
    }
    return triangles;
}

/// Neighbours know each other, triangles run counter-clockwise, and edges that are not fixed are Delaunay.
void check_structure(const Triangulation& triangles)
{
    bool is_linked = true, has_area = true, is_delaunay = true;
    for (Index t = 0; t < triangles.n_triangles(); ++t) {
        const auto& [a, b, c] = triangles.vertices(t);
        has_area = has_area && orientation(triangles.at(a), triangles.at(b), triangles.at(c)) > 0.0;
        for (Index corner = 3 * t; corner < 3 * t + 3; ++corner) {
            const Index twin = triangles.twin(corner);
            if (twin == Triangulation::none) continue;
            is_linked = is_linked && triangles.twin(twin) == corner &&
                        triangles.vertex(Triangulation::next(corner)) ==
                            triangles.vertex(Triangulation::previous(twin));
            is_delaunay = is_delaunay &&
                          (triangles.is_fixed(corner) || in_circle(triangles.at(a), triangles.at(b), triangles.at(c),
                                                                   triangles.at(triangles.vertex(twin))) <= 0.0);
        }
    }
    CHECK(is_linked);
    CHECK(has_area);
    CHECK(is_delaunay);
    for (Index v = 0; v < triangles.n_vertices(); ++v) CHECK(triangles.vertex(triangles.corner_of(v)) == v);
}

} // namespace

TEST_SUITE("triangulations")
{
    TEST_CASE("Places of a lattice, with many in line and on one circle, are triangulated by Delaunay's rule")
    {
        for (unsigned seed = 1; seed <= 20; ++seed) {
            CAPTURE(seed);
            const Triangulation triangles = of_random_places(150, seed);
            CHECK(triangles.n_triangles() == 2 * 150 + 1); // Euler, with the three of the frame
            check_structure(triangles);
        }
    }

    TEST_CASE("An edge between any two vertices is made or what is in its way is named; the rest stays Delaunay")
    {
        for (unsigned seed = 1; seed <= 20; ++seed) {
            Triangulation triangles = of_random_places(80, seed);
            std::mt19937 random(seed);
            std::uniform_int_distribution<Index> any(Triangulation::n_frame_vertices, 82);
            int n_made = 0;
            for (int i = 0; i < 60; ++i) {
                const Index a = any(random), b = any(random);
                if (a == b) continue;
                const auto obstacle = triangles.fix(a, b);
                CAPTURE(seed);
                CAPTURE(i);
                if (!obstacle) {
                    ++n_made;
                    CHECK(triangles.triangle_left_of(a, b).has_value());
                    continue;
                }
                const auto& [u, v] = *obstacle;
                const FlatPoint &p = triangles.at(a), &q = triangles.at(b);
                if (u == v) CHECK(orientation(p, q, triangles.at(u)) == 0.0);
                else CHECK(orientation(p, q, triangles.at(u)) * orientation(p, q, triangles.at(v)) < 0.0);
            }
            CHECK(n_made > 5);
            check_structure(triangles);
        }
    }

    TEST_CASE("An edge along the outside, past places in line, takes the place of those to the frame")
    {
        FlatBox box;
        box.add({0.0, 0.0});
        box.add({10.0, 3.0});
        Triangulation triangles(box);
        for (int i = 0; i <= 8; ++i) insert(triangles, {static_cast<double>(i), 0.1 * i * (8 - i) / 16.0});
        insert(triangles, {9.0, -2.0});
        insert(triangles, {-1.0, 3.0});
        REQUIRE_FALSE(triangles.fix(13, 12).has_value());
        check_structure(triangles);
        REQUIRE_FALSE(triangles.fix(11, 13).has_value());
        check_structure(triangles);
    }

    TEST_CASE("A place on a vertex, and one behind an edge that is fixed, have no cavity")
    {
        FlatBox box;
        box.add({0.0, 0.0});
        box.add({4.0, 4.0});
        Triangulation triangles(box);
        for (const FlatPoint& at : {FlatPoint{0.0, 0.0}, {4.0, 0.0}, {4.0, 4.0}, {0.0, 4.0}}) insert(triangles, at);
        CHECK(triangles.cavity({4.0, 4.0}, 0) == nullptr);
        REQUIRE_FALSE(triangles.fix(3, 5).has_value());
        const Index below = *triangles.triangle_left_of(5, 3) == *triangles.triangle_left_of(3, 5)
                                ? 0
                                : *triangles.triangle_left_of(5, 3);
        CHECK(triangles.cavity({3.0, 1.0}, below) != nullptr);
        CHECK(triangles.cavity({1.0, 3.0}, below) == nullptr);
        CHECK(triangles.cavity({2.0, 2.0}, below) == nullptr);
    }
}
