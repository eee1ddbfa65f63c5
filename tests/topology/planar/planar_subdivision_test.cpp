#include <doctest/doctest.h>

#include <numbers>
#include <random>

#include "topology/halfedge/check/validate.h"
#include "topology/planar/planar_subdivision.h"

using namespace topology;
using doctest::Approx;

namespace {

constexpr double pi = std::numbers::pi;

void draw(PlanarSubdivision& plane, const FlatPoint& a, const FlatPoint& b)
{
    REQUIRE(!plane.insert(Curve(Segment{a, b}), {a, b}));
}
void draw(PlanarSubdivision& plane, const std::vector<FlatPoint>& corners)
{
    for (std::size_t i = 0; i < corners.size(); ++i) draw(plane, corners[i], corners[(i + 1) % corners.size()]);
}
Curve circle_about(const FlatPoint& center, double r) { return EllipticArc{center, {r, 0.0}, {0.0, r}, 0.0, 2.0 * pi}; }
void draw_circle(PlanarSubdivision& plane, const FlatPoint& center, double r)
{
    const FlatPoint right{center.x + r, center.y};
    REQUIRE(!plane.insert(circle_about(center, r), {right, right}));
}
std::vector<FlatPoint> square(double low, double high) { return {{low, low}, {high, low}, {high, high}, {low, high}}; }

std::vector<double> areas(const PlanarSubdivision& plane)
{
    std::vector<double> found;
    for (const FaceId f : plane.solid().faces())
        if (f != plane.unbounded()) found.push_back(plane.area(f));
    std::ranges::sort(found, std::greater());
    return found;
}

/// Everything that must hold of any subdivision.
void check_sound(const PlanarSubdivision& plane)
{
    const auto breach = why_not_valid(plane.solid());
    CHECK_MESSAGE(!breach, (breach ? sentence(*breach) : ""));
    const PlanarCounts counts = plane.counts();
    CHECK(counts.vertices + counts.regions == counts.edges + counts.components);
    for (const FaceId f : plane.solid().faces()) {
        if (f == plane.unbounded()) continue;
        CHECK(plane.area(f) > 0.0);
        const FlatPoint inside = plane.place_inside(f);
        CHECK(plane.face_at(inside) == f);
        CHECK(!plane.edge_at(inside));
    }
}

/// A drawing as a list of curves with their ends.
struct Drawn {
    Curve curve;
    std::array<FlatPoint, 2> ends;
};

std::vector<Drawn> random_drawing(std::mt19937& dice, int range)
{
    const auto number = [&] { return static_cast<double>(dice() % static_cast<unsigned>(range)); };
    std::vector<Drawn> drawn;
    for (auto i = 3 + dice() % 18; i > 0; --i) {
        const FlatPoint a{number(), number()}, b{number(), number()};
        if (dice() % 3 == 0) {
            const double r = 1.0 + number() / 3.0;
            drawn.push_back({circle_about(a, r), {FlatPoint{a.x + r, a.y}, FlatPoint{a.x + r, a.y}}});
        } else if (!(a == b)) drawn.push_back({Segment{a, b}, {a, b}});
    }
    return drawn;
}

/// The corners of columns of width 1 side by side, each from one whole height to another: level edges of length 1.
struct Skyline {
    std::vector<int> low, high;
    bool is_upright = true; ///< else columns lie on their sides

    bool has(const FlatPoint& p) const ///< \pre not on its outline
    {
        const double along = is_upright ? p.x : p.y, across = is_upright ? p.y : p.x;
        const auto i = static_cast<std::size_t>(std::max(0.0, along));
        return along > 0.0 && i < low.size() && low[i] < across && across < high[i];
    }
    double area() const
    {
        double sum = 0.0;
        for (std::size_t i = 0; i < low.size(); ++i) sum += high[i] - low[i];
        return sum;
    }
    std::vector<FlatPoint> corners() const
    {
        std::vector<FlatPoint> found;
        const auto add = [&](std::size_t along, int across) {
            const FlatPoint p{static_cast<double>(along), static_cast<double>(across)};
            const FlatPoint corner = is_upright ? p : FlatPoint{p.y, p.x};
            if (found.empty() || !(found.back() == corner)) found.push_back(corner);
        };
        for (std::size_t i = 0; i < low.size(); ++i) {
            add(i, low[i]);
            add(i + 1, low[i]);
        }
        for (std::size_t i = low.size(); i-- > 0;) {
            add(i + 1, high[i]);
            add(i, high[i]);
        }
        return found;
    }
};

Skyline random_skyline(std::mt19937& dice)
{
    Skyline skyline;
    skyline.is_upright = dice() % 2 == 0;
    int low = 0, high = 3;
    for (auto i = 3 + dice() % 6; i > 0; --i) { // neighbours share a stretch of at least 1
        skyline.low.push_back(low);
        skyline.high.push_back(high);
        low = std::min(low + static_cast<int>(dice() % 3) - 1, high - 1);
        high = std::max(high + static_cast<int>(dice() % 3) - 1, std::max(low, skyline.low.back()) + 1);
        low = std::min(low, std::min(high, skyline.high.back()) - 1);
    }
    return skyline;
}

/// How often the loops of a face of straight edges run around p.
int winding(const PlanarSubdivision& plane, FaceId f, const FlatPoint& p)
{
    int turns = 0;
    for (const LoopId l : plane.solid().loops(f))
        for (const HalfEdgeId h : plane.solid().chain(l)) {
            if (!plane.solid().edge(h)) continue;
            const FlatPoint a = plane.at(plane.solid().start(h)), b = plane.at(plane.solid().end(h));
            if (a.y <= p.y && b.y > p.y && turn(a, b, p) > 0.0) ++turns;
            if (a.y > p.y && b.y <= p.y && turn(a, b, p) < 0.0) --turns;
        }
    return turns;
}

} // namespace

TEST_SUITE("planar subdivision")
{
    TEST_CASE("Three unit circles through each other's centres have the regions of the closed forms")
    {
        PlanarSubdivision plane(1e-9);
        draw_circle(plane, {0.0, 0.0}, 1.0);
        draw_circle(plane, {1.0, 0.0}, 1.0);
        draw_circle(plane, {0.5, std::sqrt(0.75)}, 1.0);
        CHECK(plane.counts() == PlanarCounts{.vertices = 7, .edges = 13, .regions = 7, .components = 1, .dangling = 0});
        const std::vector<double> found = areas(plane);
        CHECK(found[3] == Approx(0.5 * (pi - std::sqrt(3.0))).epsilon(1e-12)); // Reuleaux's triangle
        CHECK(found[4] == Approx(pi / 6.0).epsilon(1e-12));                    // a lens less the triangle
        check_sound(plane);
    }

    TEST_CASE("All chords of a regular polygon cross as Poonen and Rubinstein count, and split it into as many regions")
    {
        // Poonen and Rubinstein, SIAM J. Discrete Math. 11 (1998), table 1
        constexpr std::array<std::array<int, 3>, 7> counted{
            {{6, 13, 24}, {7, 35, 50}, {8, 49, 80}, {9, 126, 154}, {10, 161, 220}, {11, 330, 375}, {12, 301, 444}}};
        for (const auto& [corners_wanted, inside, regions] : counted) {
            const int n = corners_wanted; // clang 14 captures no bindings
            CAPTURE(n);
            PlanarSubdivision plane(1e-8);
            std::vector<FlatPoint> corners;
            for (int i = 0; i < n; ++i) corners.push_back({std::cos(2.0 * pi * i / n), std::sin(2.0 * pi * i / n)});
            for (std::size_t i = 0; i < corners.size(); ++i)
                for (std::size_t j = i + 1; j < corners.size(); ++j) draw(plane, corners[i], corners[j]);
            CHECK(plane.counts().vertices == static_cast<std::size_t>(inside + n));
            CHECK(plane.counts().regions == static_cast<std::size_t>(regions));
            check_sound(plane);
        }
    }

    TEST_CASE("An island in a hole is a region of its own, in whatever order the outlines are drawn")
    {
        const std::vector<std::vector<FlatPoint>> outlines{square(0, 10), square(2, 8), square(4, 6)};
        std::vector<std::size_t> order{0, 1, 2};
        do {
            PlanarSubdivision plane(1e-9);
            for (const std::size_t i : order) draw(plane, outlines[i]);
            CHECK(plane.counts() ==
                  PlanarCounts{.vertices = 12, .edges = 12, .regions = 3, .components = 3, .dangling = 0});
            CHECK(areas(plane) == std::vector{64.0, 32.0, 4.0});
            CHECK(plane.n_holes(plane.face_at({1.0, 1.0})) == 1);
            CHECK(plane.n_holes(plane.face_at({5.0, 5.0})) == 0);
            CHECK(plane.perimeter(plane.face_at({3.0, 3.0})) == Approx(32.0));
            check_sound(plane);
        } while (std::next_permutation(order.begin(), order.end()));
    }

    TEST_CASE("Lines that overlap are one chain of edges, and each edge knows all that run along it")
    {
        PlanarSubdivision plane(1e-9);
        for (int i = 0; i < 10; ++i) draw(plane, {1.0 * i, 0.0}, {i + 3.0, 0.0});
        CHECK(plane.counts() ==
              PlanarCounts{.vertices = 13, .edges = 12, .regions = 0, .components = 1, .dangling = 12});
        std::size_t n_carried = 0;
        for (const EdgeId e : plane.solid().edges()) n_carried += plane.carriers(e).size();
        CHECK(n_carried == 30); // ten lines of three edges
    }

    TEST_CASE("Arcs of one circle overlap likewise, from wherever they start")
    {
        PlanarSubdivision plane(1e-9);
        draw_circle(plane, {0.0, 0.0}, 1.0);
        draw_circle(plane, {0.0, 0.0}, 1.0);
        CHECK(plane.counts() == PlanarCounts{.vertices = 1, .edges = 1, .regions = 1, .components = 1, .dangling = 0});
        const Curve arc = EllipticArc{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, 2.0, -3.0}; // clockwise, over the start
        REQUIRE(!plane.insert(arc, {arc.at(0.0), arc.at(1.0)}));
        CHECK(plane.counts() == PlanarCounts{.vertices = 3, .edges = 3, .regions = 1, .components = 1, .dangling = 0});
        CHECK(areas(plane).front() == Approx(pi).epsilon(1e-12));
    }

    TEST_CASE("A dangling edge and a lone point divide nothing")
    {
        PlanarSubdivision plane(1e-9);
        plane.insert(FlatPoint{1.0, 1.0});
        draw(plane, {{0, 0}, {4, 0}, {4, 2}, {0, 2}});
        draw(plane, {2.0, 0.0}, {2.0, 2.0});
        draw(plane, {3.0, 2.0}, {3.0, 1.0});
        CHECK(plane.counts() == PlanarCounts{.vertices = 9, .edges = 9, .regions = 2, .components = 2, .dangling = 1});
        CHECK(areas(plane) == std::vector{4.0, 4.0});
        CHECK(plane.perimeter(plane.face_at({3.5, 1.0})) == Approx(8.0));
        check_sound(plane);
    }

    TEST_CASE("Curves that touch meet in one vertex, and the wedge between them is a region")
    {
        PlanarSubdivision plane(1e-9);
        draw_circle(plane, {0.0, 0.0}, 1.0);
        draw_circle(plane, {3.0, 0.0}, 1.0);
        draw_circle(plane, {1.5, 0.0}, 0.5);
        draw(plane, {-5.0, 1.0}, {5.0, 1.0});
        CHECK(plane.counts() == PlanarCounts{.vertices = 7, .edges = 10, .regions = 4, .components = 1, .dangling = 2});
        CHECK(areas(plane)[2] == Approx(3.0 - 0.5 * pi - 0.125 * pi).epsilon(1e-9));
        check_sound(plane);
    }

    TEST_CASE("A curve that crosses itself encloses its loop")
    {
        const Curve loop = CubicBezier{{{{0.0, 0.0}, {3.0, 3.0}, {-2.0, 3.0}, {1.0, 0.0}}}};
        PlanarSubdivision plane(1e-9);
        REQUIRE(!plane.insert(loop, {FlatPoint{0.0, 0.0}, FlatPoint{1.0, 0.0}}));
        CHECK(plane.counts() == PlanarCounts{.vertices = 3, .edges = 3, .regions = 1, .components = 1, .dangling = 2});
        const std::vector<double> t = loop.self_crossing();
        CHECK(areas(plane).front() == Approx(loop.area({t[0], t[1]}, loop.at(t[0]))).epsilon(1e-12));
        draw(plane, {-5.0, 1.0}, {5.0, 1.0});
        check_sound(plane);
    }

    TEST_CASE("A cubic that slows down to nothing at its end meets what it ends on there alone, whatever snap is")
    {
        const FlatPoint end{0.0, 2.0};
        const Curve slowing = CubicBezier{{{{2.0, 2.0}, {2.0, 7.0}, end, end}}};
        const FlatPoint center{4.5, 2.0 + 4.0 / 3.0}; // of an arc through the end, which is its point at 0.5
        const double r = distance(center, end), from = std::atan2(end.y - center.y, end.x - center.x) - 1.0;
        const Curve arc = EllipticArc{center, {r, 0.0}, {0.0, r}, from, 2.0};
        for (double snap = 1e-9; snap < 1e-7; snap *= 1.07) {
            CAPTURE(snap);
            PlanarSubdivision plane(snap);
            REQUIRE(!plane.insert(slowing, {FlatPoint{2.0, 2.0}, end}));
            REQUIRE(!plane.insert(arc, {arc.at(0.0), arc.at(1.0)}));
            CHECK(plane.counts().vertices == 4);
            CHECK(plane.counts().edges == 3);
        }
    }

    TEST_CASE("A vertex nearer to an edge than snap lies on it, one farther away does not")
    {
        for (const double off : {0.4e-6, 3.0e-6}) {
            PlanarSubdivision plane(1e-6);
            draw(plane, {0.0, 0.0}, {4.0, 0.0});
            draw(plane, {2.0, off}, {2.0, 3.0});
            CHECK(plane.counts().components == (off < 1e-6 ? 1 : 2));
        }
    }

    TEST_CASE("Curves that run together are refused, and nothing has changed")
    {
        const Curve bezier = CubicBezier{{{{0.0, 0.0}, {1.0, 2.0}, {2.0, -2.0}, {3.0, 0.5}}}};
        const std::array<FlatPoint, 2> ends{FlatPoint{0.0, 0.0}, FlatPoint{3.0, 0.5}};
        PlanarSubdivision plane(1e-9);
        REQUIRE(!plane.insert(bezier, ends));
        const Solid before = plane.solid();
        const auto refusal = plane.insert(bezier, ends);
        REQUIRE(refusal);
        CHECK(refusal->runs_along == CurveIndex{0});
        CHECK(plane.solid() == before);
        CHECK(plane.n_curves() == 1);
    }

    TEST_CASE("A circle level with a ledge of an outline is outside it, and a place there as well")
    {
        PlanarSubdivision plane(1e-9);
        draw(plane, {{0, 0}, {10, 0}, {10, 8}, {5, 8}, {5, 4}, {0, 4}});
        CHECK(plane.face_at({-2.0, 4.0}) == plane.unbounded());
        draw_circle(plane, {-2.0, 4.0}, 0.5);
        CHECK(areas(plane).front() == Approx(60.0).epsilon(1e-12));
        check_sound(plane);
    }

    TEST_CASE("Islands level with edges of a rectilinear outline are in it or not, in any order of curves")
    {
        std::mt19937 dice(18);
        for (int drawing = 0; drawing < 300; ++drawing) {
            CAPTURE(drawing);
            const Skyline skyline = random_skyline(dice);
            const std::vector<FlatPoint> corners = skyline.corners();
            std::vector<Drawn> curves;
            for (std::size_t i = 0; i < corners.size(); ++i) {
                const FlatPoint a = corners[i], b = corners[(i + 1) % corners.size()];
                curves.push_back({Segment{a, b}, {a, b}});
            }
            constexpr double r = 0.11;
            double wanted = skyline.area();
            for (int x = -3; x < 12; ++x)
                for (int y = -3; y < 12; ++y) {
                    const bool is_level = dice() % 2 == 0;
                    const FlatPoint at{x + (is_level ? 0.4 : 0.0), y + (is_level ? 0.0 : 0.4)};
                    const auto is_on_edge = [&](const Drawn& each) {
                        return distance(each.curve.at(each.curve.nearest(at, {})), at) < r;
                    };
                    if (dice() % 8 != 0 || std::ranges::any_of(curves, is_on_edge)) continue;
                    const FlatPoint right{at.x + r, at.y};
                    curves.push_back({circle_about(at, r), {right, right}});
                    if (skyline.has(at)) wanted -= pi * r * r;
                }
            std::shuffle(curves.begin(), curves.end(), dice);
            PlanarSubdivision plane(1e-9);
            for (const Drawn& each : curves) REQUIRE(!plane.insert(each.curve, each.ends));
            CHECK(areas(plane).front() == Approx(wanted).epsilon(1e-12));
            check_sound(plane);
        }
    }

    TEST_CASE("A place level with vertices and edges is in the face whose loops run around it")
    {
        std::mt19937 dice(21);
        const auto number = [&] { return static_cast<double>(dice() % 6); };
        for (int drawing = 0; drawing < 300; ++drawing) {
            CAPTURE(drawing);
            PlanarSubdivision plane(1e-9);
            plane.insert(FlatPoint{2.0, 2.0});
            for (auto i = 4 + dice() % 16; i > 0; --i) {
                const FlatPoint a{number(), number()}, b{number(), dice() % 3 == 0 ? a.y : number()};
                if (!(a == b)) draw(plane, a, b);
            }
            for (int place = 0; place < 60; ++place) {
                const FlatPoint p{number() - 1.0 + 0.37 * static_cast<double>(dice() % 3), number()};
                if (plane.edge_at(p) || p == FlatPoint{2.0, 2.0}) continue;
                const FaceId found = plane.face_at(p);
                CAPTURE(p.x);
                CAPTURE(p.y);
                for (const FaceId f : plane.solid().faces())
                    CHECK((winding(plane, f, p) > 0) == (f == found && f != plane.unbounded()));
            }
        }
    }

    TEST_CASE(
        "What undo makes whole again is found where it was before, also if all was put into other cells meanwhile")
    {
        PlanarSubdivision plane(1e-9);
        draw_circle(plane, {0.0, 0.0}, 1.0);
        plane.insert({0.25, 0.0});
        const PlanarCounts counts = plane.counts();
        draw(plane, {-2.0, 0.0}, {0.25, 0.0}); // cuts the circle, and its end is a vertex that was alone
        draw(plane, {90.0, 90.0}, {99.0, 99.0});
        plane.undo();
        plane.undo();
        CHECK(plane.counts() == counts);
        check_sound(plane);
        CHECK(plane.face_at({-0.5, 0.1}) != plane.unbounded());
        draw(plane, {0.25, 0.0}, {0.5, 0.0});
        CHECK(plane.counts() == PlanarCounts{.vertices = 3, .edges = 2, .regions = 1, .components = 2, .dangling = 1});
    }

    TEST_CASE("Any order of curves gives the same subdivision, and undo takes every one back bit for bit")
    {
        std::mt19937 dice(7);
        for (int drawing = 0; drawing < 60; ++drawing) {
            CAPTURE(drawing);
            const int range = drawing % 3 == 0 ? 5 : 1000; // a few places that are used again and again, or many
            std::vector<Drawn> curves = random_drawing(dice, range);
            std::optional<PlanarCounts> counts;
            std::vector<double> sizes;
            for (int order = 0; order < 3; ++order) {
                PlanarSubdivision plane(1e-7 * range);
                std::vector<Solid> states;
                for (const Drawn& each : curves) {
                    states.push_back(plane.solid());
                    REQUIRE(!plane.insert(each.curve, each.ends));
                }
                check_sound(plane);
                if (!counts) {
                    counts = plane.counts();
                    sizes = areas(plane);
                }
                CHECK(plane.counts() == *counts);
                const std::vector<double> again = areas(plane);
                for (std::size_t i = 0; i < std::min(sizes.size(), again.size()); ++i)
                    CHECK(again[i] == Approx(sizes[i]).epsilon(1e-6));
                for (; !states.empty(); states.pop_back()) {
                    plane.undo();
                    CHECK(plane.solid() == states.back());
                    check_sound(plane);
                }
                std::shuffle(curves.begin(), curves.end(), dice);
            }
        }
    }
}
