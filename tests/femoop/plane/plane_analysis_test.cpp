#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "femoop/analysis/mechanism.h"
#include "femoop/io/plane/plane_file.h"
#include "femoop/plane/analysis/plane_analysis.h"
#include "femoop/plane/analysis/plane_structure.h"
#include "femoop/plane/analysis/result_reader.h"
#include "tests/femoop/plane/plane_text.h"

using namespace femoop;
using namespace femoop::plane;

namespace {

constexpr double E = 71.0e3, nu = 0.27, alpha = 2.3e-5, density = 2.7e-9; // of PlaneText
constexpr double length = 7.0, height = 2.0, thickness = 0.4;             // of the two elements together

/// Held as a body that may narrow: ux along the left side, uy at its foot.
constexpr std::string_view free_to_narrow =
    R"([{"id": "left", "kind": "edges", "points": ["D", "A"], "support": {"fixed": ["ux"]}},
        {"id": "bottom", "kind": "edges", "points": ["A", "B", "C"], "support": "roller"},
        {"id": "right", "kind": "edges", "points": ["C", "F"]},
        {"id": "top", "kind": "edges", "points": ["F", "E", "D"]}])";

PlaneText narrowing(std::string_view load_case) { return {.curves = free_to_narrow, .load_case = load_case}; }

struct Solved {
    PlaneModel model;
    PlaneResults results;
    PlaneCase first;
};
Solved solved(const PlaneText& text)
{
    PlaneModel model = read_plane_model(text.text());
    PlaneResults results = analyse(model);
    return {model, results, results[CaseId(0)]};
}

constexpr NodeId A(0), B(1), C(2), D(3), F(5);
constexpr RegionId web(0), rib(1);

std::vector<NodeId> everywhere(const PlaneModel& model)
{
    std::vector<NodeId> nodes;
    for (std::size_t i = 0; i < model.points.size(); ++i) nodes.emplace_back(i);
    return nodes;
}

/// nx by ny rectangles.
PlaneModel many_elements(std::uint32_t nx, std::uint32_t ny)
{
    PlaneModel model;
    model.materials.push_back({.id = "m", .E = 3.0, .nu = 0.3});
    model.regions.push_back({.id = "sheet", .material = MaterialId(0), .thickness = 0.7});
    for (std::uint32_t j = 0; j <= ny; ++j)
        for (std::uint32_t i = 0; i <= nx; ++i)
            model.points.push_back({.id = std::to_string(model.points.size()), .at = {1.1 * i, 1.3 * j}});
    const auto at = [&](std::uint32_t i, std::uint32_t j) { return NodeId(j * (nx + 1) + i); };
    for (std::uint32_t j = 0; j < ny; ++j)
        for (std::uint32_t i = 0; i < nx; ++i)
            model.elements.push_back({.id = std::to_string(model.elements.size()),
                                      .kind = ShapeKind::Q4,
                                      .points = {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)},
                                      .region = RegionId(0)});
    return model;
}

std::string refusal(const PlaneText& text)
{
    try {
        analyse(read_plane_model(text.text()));
    } catch (const MechanismError& error) {
        std::string sentences;
        for (const Mechanism& mechanism : error.mechanisms())
            sentences += (sentences.empty() ? "" : "\n") + message(mechanism.fault);
        return sentences;
    }
    return "";
}

} // namespace

TEST_CASE("A sheet that is pulled grows by q L / E and narrows by nu times that")
{
    const double q = 13.0;
    const auto [model, results,
                P] = solved(narrowing(R"(, "curves": [{"curve": "right", "kind": "traction", "qx": 13}])"));
    CHECK(P.displacement(F).x() == doctest::Approx(q * length / E).epsilon(1e-12));
    CHECK(P.displacement(F).y() == doctest::Approx(-nu * q * height / E).epsilon(1e-12));
    CHECK(P.smoothed_stress(B, rib).sx == doctest::Approx(q).epsilon(1e-12));
    CHECK(P.smoothed_strain(B, web).ez == doctest::Approx(-nu * q / E).epsilon(1e-12));
    CHECK(P.energy() == doctest::Approx(0.5 * q * q / E * length * height * thickness).epsilon(1e-12));
    CHECK(P.reaction(everywhere(model)).x() == doctest::Approx(-q * height * thickness).epsilon(1e-12));
    CHECK(P.error_estimate() < 1e-10);
}

TEST_CASE("A line load is the traction times the thickness, on local axes along the curve and to its left")
{
    // `right` runs upwards: along it is +y, to its left is -x.
    const auto by_line = solved(
        narrowing(R"(, "curves": [{"curve": "right", "kind": "line", "qy": -5.2, "axes": "local"}])"));
    CHECK(by_line.first.displacement(F).x() == doctest::Approx(5.2 / thickness * length / E).epsilon(1e-12));
    const auto along = solved(
        PlaneText{.load_case = R"(, "curves": [{"curve": "right", "kind": "traction", "qx": 3, "axes": "local"}])"});
    CHECK(along.first.reaction(everywhere(along.model)).y() ==
          doctest::Approx(-3.0 * height * thickness).epsilon(1e-12));
}

TEST_CASE("A pressure pushes into the material, whichever way its curve runs")
{
    for (const std::string_view points : {R"(["C", "F"])", R"(["F", "C"])"}) {
        CAPTURE(points);
        const std::string curves =
            R"([{"id": "left", "kind": "edges", "points": ["D", "A"], "support": {"fixed": ["ux"]}},
            {"id": "bottom", "kind": "edges", "points": ["A", "B", "C"], "support": "roller"},
            {"id": "right", "kind": "edges", "points": )" +
            std::string(points) + "}]";
        const auto [model, results, P] = solved(
            {.curves = curves, .load_case = R"(, "curves": [{"curve": "right", "kind": "pressure", "value": 13}])"});
        CHECK(P.displacement(F).x() == doctest::Approx(-13.0 * length / E).epsilon(1e-12));
    }
}

TEST_CASE("A field from end to end, a polynomial and a table of the same values load alike")
{
    // 4 at the foot, 9 at the head: N = mean, its moment about mid-height h^2 t / 12 times the slope.
    std::array<double, 4> tips{};
    std::size_t i = 0;
    for (const std::string_view field :
         {R"([4, 9])", R"({"polynomial": [[4, 0, 0], [2.5, 0, 1]]})", R"({"along": "y", "table": [[0, 4], [2, 9]]})",
          R"({"along": "s", "table": [[0, 4], [2, 9]]})"}) {
        CAPTURE(field);
        const std::string load_case = R"(, "curves": [{"curve": "right", "kind": "traction", "qx": )" +
                                      std::string(field) + "}]";
        const auto [model, results, P] = solved({.load_case = load_case});
        CHECK(P.reaction(everywhere(model)).x() == doctest::Approx(-6.5 * height * thickness).epsilon(1e-12));
        CHECK(P.reaction_moment(everywhere(model), {0.0, 1.0}) ==
              doctest::Approx(thickness * height * height / 12.0 * 5.0).epsilon(1e-12));
        tips.at(i++) = P.displacement(F).x();
    }
    for (const double tip : tips) CHECK(tip == doctest::Approx(tips[0]).epsilon(1e-12));
}

TEST_CASE("A body that its springs carry along, or that swells freely, has neither stress nor reactions")
{
    constexpr std::string_view sprung =
        R"([{"id": "left", "kind": "edges", "points": ["D", "A"], "support": "symmetry"},
            {"id": "bottom", "kind": "edges", "points": ["A", "B", "C"], "support": {"springs": {"uy": 50}}}])";
    for (const std::string_view load_case : {R"(, "settlements": [{"curve": "bottom", "uy": -0.37}])",
                                             R"(, "regions": [{"kind": "temperature", "rise": 37}])"}) {
        CAPTURE(load_case);
        const bool settles = load_case.find("settlements") != std::string_view::npos;
        const auto [model, results,
                    P] = solved(settles ? PlaneText{.curves = sprung, .load_case = load_case} : narrowing(load_case));
        CHECK(P.energy() == 0.0);
        CHECK(P.equilibrium().sum_reactions[1] == 0.0);
        for (std::size_t i = 0; i < model.points.size(); ++i) {
            CHECK(P.reaction(NodeId(i)).norm() == 0.0);
            if (settles) CHECK(P.displacement(NodeId(i)).y() == doctest::Approx(-0.37).epsilon(1e-12));
        }
        CHECK(von_mises(P.smoothed_stress(B, rib)) == 0.0);
        CHECK(von_mises(P.element_stress(B, web)) == 0.0);
        if (!settles) CHECK(P.smoothed_strain(B, web).ex == doctest::Approx(alpha * 37.0).epsilon(1e-12));
    }
}

TEST_CASE("Water that reaches to within an edge presses by its triangle")
{
    // 9 at the foot of a side of height 2, nothing above the level.
    for (const double level : {0.3, 1.3, 1.99})
        for (const std::string_view points : {R"(["C", "F"])", R"(["F", "C"])"})
            for (const std::string_view along : {R"("y")", R"("r", "about": [7, 0])"}) {
                CAPTURE(level);
                CAPTURE(points);
                const std::string field = R"({"along": )" + std::string(along) + R"(, "table": [[0, 9], [)" +
                                          std::to_string(level) + ", 0]]}";
                const std::string curves =
                    R"([{"id": "left", "kind": "edges", "points": ["D", "A"], "support": {"fixed": ["ux"]}},
                {"id": "bottom", "kind": "edges", "points": ["A", "B", "C"], "support": "roller"},
                {"id": "right", "kind": "edges", "points": )" +
                    std::string(points) + "}]";
                const std::string load_case = R"(, "curves": [{"curve": "right", "kind": "pressure", "value": )" +
                                              field + "}]";
                const auto [model, results, P] = solved({.curves = curves, .load_case = load_case});
                const double force = 0.5 * 9.0 * level * thickness;
                CHECK(P.reaction(everywhere(model)).x() == doctest::Approx(force).epsilon(1e-12));
                CHECK(P.reaction_moment(everywhere(model), {0.0, 0.0}) ==
                      doctest::Approx(-force * level / 3.0).epsilon(1e-12));
            }
}

TEST_CASE("A body that is warmed and free strains by alpha T without stress; held, its stress is -E alpha T")
{
    const double T = 40.0;
    constexpr std::string_view warm = R"(, "regions": [{"kind": "temperature", "rise": 40}])";
    const auto free = solved(narrowing(warm));
    CHECK(free.first.displacement(F).x() == doctest::Approx(alpha * T * length).epsilon(1e-12));
    CHECK(std::abs(free.first.smoothed_stress(B, web).sx) < 1e-9 * E * alpha * T);
    CHECK(free.first.energy() < 1e-18 * E);
    CHECK(free.first.smoothed_strain(B, web).ez == doctest::Approx(alpha * T).epsilon(1e-12));
    constexpr std::string_view held =
        R"([{"id": "left", "kind": "edges", "points": ["D", "A"], "support": {"fixed": ["ux"]}},
            {"id": "right", "kind": "edges", "points": ["C", "F"], "support": {"fixed": ["ux"]}},
            {"id": "bottom", "kind": "edges", "points": ["A", "B", "C"], "support": "roller"}])";
    const auto [model, results, P] = solved({.curves = held, .load_case = warm});
    CHECK(P.element_stress(B, rib).sx == doctest::Approx(-E * alpha * T).epsilon(1e-11));
    CHECK(P.reaction(C).x() + P.reaction(F).x() == doctest::Approx(-E * alpha * T * height * thickness).epsilon(1e-11));
    CHECK(P.energy() == doctest::Approx(0.5 * E * alpha * alpha * T * T * length * height * thickness).epsilon(1e-11));
}

TEST_CASE("In a warmed slice of a long body ez stays 0 and sz does not")
{
    const PlaneText slice{.analysis = "plane_strain",
                          .curves = free_to_narrow,
                          .load_case = R"(, "regions": [{"kind": "temperature", "rise": 40}])"};
    const auto [model, results, P] = solved(slice);
    CHECK(std::abs(P.smoothed_strain(B, web).ez) < 1e-15);
    CHECK(P.smoothed_stress(B, web).sz == doctest::Approx(-E * alpha * 40.0).epsilon(1e-12));
    CHECK(P.displacement(F).x() == doctest::Approx((1.0 + nu) * alpha * 40.0 * length).epsilon(1e-12));
}

TEST_CASE("Weight, a body force and a steady rotation bring the forces of their mass")
{
    const double mass = density * length * height * thickness, g = 9806.65; // mm/s^2
    const auto weight = solved(PlaneText{.load_case = R"(, "self_weight": 2.5)"});
    CHECK(weight.first.reaction(everywhere(weight.model)).y() == doctest::Approx(2.5 * mass * g).epsilon(1e-12));
    const auto body = solved(PlaneText{.load_case = R"(, "regions": [{"region": "rib", "kind": "body", "bx": 0.25}])"});
    CHECK(body.first.reaction(everywhere(body.model)).x() ==
          doctest::Approx(-0.25 * 4.0 * height * thickness).epsilon(1e-12));
    const auto turning = solved(
        PlaneText{.load_case = R"(, "regions": [{"kind": "rotation", "omega": 300, "about": [1.5, 0]}])"});
    const Eigen::Vector2d arm(0.5 * length - 1.5, 0.5 * height);
    const Eigen::Vector2d force = turning.first.reaction(everywhere(turning.model));
    CHECK(force.x() == doctest::Approx(-mass * 9.0e4 * arm.x()).epsilon(1e-12));
    CHECK(force.y() == doctest::Approx(-mass * 9.0e4 * arm.y()).epsilon(1e-12));
}

TEST_CASE("A combination adds up displacements, stresses and reactions; its energy is of the sum")
{
    const PlaneText two{.curves = free_to_narrow,
                        .load_case = R"(, "curves": [{"curve": "right", "kind": "traction", "qx": 3}]},
                            {"id": "T", "regions": [{"kind": "temperature", "rise": 40}]},
                            {"id": "Q", "curves": [{"curve": "right", "kind": "traction", "qx": 5}])",
                        .more = R"(, "combinations": [{"id": "U", "factors": {"P": 2, "Q": -0.5, "T": 1.5}}])"};
    const PlaneModel model = read_plane_model(two.text());
    const PlaneCase U = analyse(model)[CaseId(3)];
    const double q = 2.0 * 3.0 - 0.5 * 5.0;
    CHECK(U.displacement(F).x() == doctest::Approx((q / E + alpha * 60.0) * length).epsilon(1e-12));
    CHECK(U.smoothed_stress(B, rib).sx == doctest::Approx(q).epsilon(1e-11));
    CHECK(U.energy() == doctest::Approx(0.5 * q * q / E * length * height * thickness).epsilon(1e-10));
}

TEST_CASE("An inclined roller lets the node move along it alone, and pushes square to it")
{
    // C stands on a roller whose axes are turned by 30 degrees: uy' is blocked.
    const std::string points = R"([{"id": "A", "at": [0, 0], "support": "pin"}, {"id": "B", "at": [3, 0]},
        {"id": "C", "at": [7, 0], "support": {"fixed": ["uy"], "angle": 30}}, {"id": "D", "at": [0, 2]},
        {"id": "E", "at": [3, 2]}, {"id": "F", "at": [7, 2]}])";
    const auto [model, results, P] = solved(
        {.points = points, .curves = "[]", .load_case = R"(, "points": [{"point": "F", "fx": 11, "fy": -4}])"});
    const Eigen::Vector2d across(-0.5, std::sqrt(0.75)), along(std::sqrt(0.75), 0.5);
    CHECK(std::abs(P.displacement(C).dot(across)) < 1e-15);
    CHECK(std::abs(P.reaction(C).dot(along)) < 1e-12);
    // About A: 2 * 11 + 7 * 4 = 7 * R cos 30
    CHECK(P.reaction(C).dot(across) ==
          doctest::Approx((2.0 * 11.0 + 7.0 * 4.0) / (7.0 * std::sqrt(0.75))).epsilon(1e-12));
    CHECK((P.reaction(A) + P.reaction(C) + Eigen::Vector2d(11.0, -4.0)).norm() < 1e-11);
}

TEST_CASE("A cut along the border of two thicknesses carries what a cut beside it carries")
{
    const double q = 13.0, thin = 0.1;
    const auto P = solved({.materials = R"([{"id": "m", "E": 71e3, "nu": 0}])",
                           .regions = R"([{"id": "web", "material": "m", "thickness": 0.4},
                                          {"id": "rib", "material": "m", "thickness": 0.1}])",
                           .load_case = R"(, "curves": [{"curve": "right", "kind": "traction", "qx": 13}])"})
                       .first;
    for (const double x : {2.5, 3.0, 3.5}) {
        CAPTURE(x);
        const CutForces forces = P.forces({{x, 0.0}, {x, height}});
        CHECK(forces.N == doctest::Approx(q * thin * height).epsilon(1e-11));
        CHECK(std::abs(forces.V) + std::abs(forces.M) < 1e-11);
    }
}

TEST_CASE("An inclined support that settles on the axis of revolution moves the node along the axis")
{
    const std::string points = R"([{"id": "A", "at": [0, 0], "support": {"fixed": ["uy"], "angle": 30}},
        {"id": "B", "at": [3, 0]}, {"id": "C", "at": [7, 0]}, {"id": "D", "at": [0, 2]}, {"id": "E", "at": [3, 2]},
        {"id": "F", "at": [7, 2]}])";
    const auto [model, results,
                P] = solved({.analysis = "axisymmetric",
                             .points = points,
                             .curves = "[]",
                             .regions = R"([{"id": "web", "material": "m"}, {"id": "rib", "material": "m"}])",
                             .load_case = R"(, "settlements": [{"point": "A", "uy": 0.01}])"});
    // ux = 0 and -ux sin 30 + uy cos 30 = 0.01
    CHECK(P.displacement(A).x() == 0.0);
    for (const NodeId node : {A, C, F})
        CHECK(P.displacement(node).y() == doctest::Approx(0.01 / std::sqrt(0.75)).epsilon(1e-12));
}

TEST_CASE("Springs along a curve and of points carry what their stiffness and their ground make of it")
{
    const double k = 250.0; // N/mm^3
    constexpr std::string_view sprung =
        R"([{"id": "left", "kind": "edges", "points": ["D", "A"], "support": {"springs": {"ux": 250}}},
            {"id": "bottom", "kind": "edges", "points": ["A", "B", "C"], "support": "roller"},
            {"id": "right", "kind": "edges", "points": ["C", "F"]}])";
    const auto pulled = solved(
        PlaneText{.curves = sprung, .load_case = R"(, "curves": [{"curve": "right", "kind": "traction", "qx": 13}])"});
    CHECK(pulled.first.displacement(D).x() == doctest::Approx(13.0 / k).epsilon(1e-11));
    CHECK(pulled.first.reaction(A).x() + pulled.first.reaction(D).x() ==
          doctest::Approx(-13.0 * height * thickness).epsilon(1e-11));
    const auto moved = solved(
        PlaneText{.curves = sprung, .load_case = R"(, "settlements": [{"curve": "left", "ux": 0.3}])"});
    CHECK(moved.first.displacement(F).x() == doctest::Approx(0.3).epsilon(1e-11));
    CHECK(std::abs(moved.first.reaction(everywhere(moved.model)).x()) < 1e-9);

    const std::string points =
        R"([{"id": "A", "at": [0, 0], "support": {"fixed": ["ux", "uy"]}}, {"id": "B", "at": [3, 0]},
        {"id": "C", "at": [7, 0], "support": {"springs": {"uy": 40}}}, {"id": "D", "at": [0, 2], "support": {"fixed": ["ux"]}},
        {"id": "E", "at": [3, 2]}, {"id": "F", "at": [7, 2]}])";
    const auto hung = solved(
        PlaneText{.points = points, .curves = "[]", .load_case = R"(, "settlements": [{"point": "C", "uy": -0.2}])"});
    CHECK(hung.first.displacement(C).y() < 0.0);
    CHECK(hung.first.reaction(C).y() == doctest::Approx(-40.0 * (hung.first.displacement(C).y() + 0.2)).epsilon(1e-9));
}

TEST_CASE("Tied nodes have one displacement, and what they hold is shared by them all")
{
    constexpr std::string_view tied =
        R"([{"id": "left", "kind": "edges", "points": ["D", "A"], "support": "fixed"},
            {"id": "right", "kind": "edges", "points": ["C", "F"], "tie": ["ux"]}])";
    const auto [model, results, P] = solved(
        {.curves = tied, .load_case = R"(, "points": [{"point": "F", "fx": 11}, {"point": "C", "fx": 2}])"});
    CHECK(P.displacement(C).x() == doctest::Approx(P.displacement(F).x()).epsilon(1e-13));
    CHECK(P.displacement(C).x() > 0.0);
    CHECK(P.reaction(everywhere(model)).x() == doctest::Approx(-13.0).epsilon(1e-11));
}

TEST_CASE("A tied curve that is held settles as far as is said")
{
    constexpr std::string_view tied =
        R"([{"id": "left", "kind": "edges", "points": ["D", "A"], "support": "fixed"},
            {"id": "right", "kind": "edges", "points": ["C", "F"], "support": {"fixed": ["ux"]}, "tie": ["ux"]}])";
    const auto P = solved({.curves = tied, .load_case = R"(, "settlements": [{"curve": "right", "ux": 0.2}])"}).first;
    for (const NodeId node : {C, F}) CHECK(P.displacement(node).x() == 0.2);
}

TEST_CASE("Each tied node is held by its own ground")
{
    constexpr std::string_view tied =
        R"([{"id": "left", "kind": "edges", "points": ["D", "A"], "support": {"fixed": ["ux"]}},
            {"id": "bottom", "kind": "edges", "points": ["A", "B", "C"], "support": {"springs": {"uy": 50}}, "tie": ["uy"]}])";
    const auto [model, results, P] = solved(
        {.curves = tied, .load_case = R"(, "points": [{"point": "D", "fy": -11}, {"point": "F", "fy": -3}])"});
    const double all = 14.0 / length; // of an even bed, by its length
    CHECK(P.reaction(A).y() == doctest::Approx(all * 1.5).epsilon(1e-11));
    CHECK(P.reaction(B).y() == doctest::Approx(all * 3.5).epsilon(1e-11));
    CHECK(P.reaction(C).y() == doctest::Approx(all * 2.0).epsilon(1e-11));
    for (const std::size_t i : {1U, 5U})
        CHECK(P.equilibrium().sum_reactions[i] == doctest::Approx(-P.equilibrium().sum_loads[i]).epsilon(1e-11));
}

TEST_CASE("An analysis that goes on finds what a new one finds, whether the equations stayed or not")
{
    constexpr std::string_view pull = R"(, "points": [{"point": "F", "fx": 11}])";
    constexpr std::string_view tied =
        R"([{"id": "left", "kind": "edges", "points": ["D", "A"], "support": "fixed"},
            {"id": "right", "kind": "edges", "points": ["C", "F"], "tie": ["ux"]}])";
    constexpr std::string_view sprung =
        R"([{"id": "left", "kind": "edges", "points": ["D", "A"], "support": "fixed"},
            {"id": "right", "kind": "edges", "points": ["C", "F"], "support": {"springs": {"ux": 90}}}])";
    constexpr std::string_view longer =
        R"([{"id": "A", "at": [0, 0]}, {"id": "B", "at": [3, 0]}, {"id": "C", "at": [9, 0]},
        {"id": "D", "at": [0, 2]}, {"id": "E", "at": [3, 2.5]}, {"id": "F", "at": [9, 2]}])";
    constexpr std::string_view turned =
        R"([{"id": "1", "kind": "Q4", "points": ["D", "A", "B", "E"], "region": "web"},
            {"id": "2", "kind": "T3", "points": ["B", "C", "F"], "region": "rib"},
            {"id": "3", "kind": "T3", "points": ["B", "F", "E"], "region": "rib"}])";
    const PlaneText plain{.load_case = pull};
    const std::array texts{plain, // each differs from the one before in one thing that equations hang on
                           PlaneText{.points = longer, .load_case = pull},
                           PlaneText{.elements = turned, .load_case = pull},
                           plain,
                           PlaneText{.curves = sprung, .load_case = pull},
                           plain,
                           PlaneText{.curves = tied, .load_case = pull},
                           narrowing(pull)};
    PlaneAnalysis analysis;
    for (const PlaneText& text : texts) {
        CAPTURE(text.text());
        const auto [model, results, P] = solved(text);
        const PlaneResults again = analysis.solve(model);
        for (const NodeId node : everywhere(model)) {
            CHECK(again[CaseId(0)].displacement(node).x() == doctest::Approx(P.displacement(node).x()).epsilon(1e-11));
            CHECK(again[CaseId(0)].reaction(node).x() ==
                  doctest::Approx(P.reaction(node).x()).epsilon(1e-11).scale(11.0));
        }
    }
}

TEST_CASE("An analysis that refused a body that can move solves the next one")
{
    PlaneAnalysis analysis;
    const std::string loose = PlaneText{.curves = R"([{"id": "left", "kind": "edges", "points": ["D", "A"]}])"}.text();
    const PlaneModel held = read_plane_model(narrowing(R"(, "points": [{"point": "F", "fx": 11}])").text());
    for (int twice = 0; twice < 2; ++twice) {
        CHECK_THROWS_AS(analysis.solve(read_plane_model(loose)), MechanismError);
        CHECK(analysis.solve(held)[CaseId(0)].displacement(F).x() > 0.0);
    }
}

TEST_CASE("A body of many elements is refused like one of few, and solved once it is held")
{
    PlaneAnalysis analysis;
    PlaneModel loose = many_elements(83, 61);
    loose.load_cases.push_back({.id = "P"});
    loose.load_cases[0].points.push_back({.node = NodeId(1), .components = {{.dof = Dof::ux, .value = 7.0}}});
    PlaneModel held = loose;
    for (const std::uint32_t node : {0U, 83U})
        held.points[node].support = PlaneSupport{.kind = PlaneSupportKind::Fixed};
    for (int twice = 0; twice < 2; ++twice) {
        try {
            analysis.solve(loose);
            FAIL("it was solved");
        } catch (const MechanismError& error) {
            CHECK(error.mechanisms().size() == 3);
        }
        CHECK(analysis.solve(held)[CaseId(0)].displacement(NodeId(1)).x() > 0.0);
    }
}

TEST_CASE("A side whose nodes are held along their own curve is one that slides on it")
{
    // A quarter ring, its inner side sliding on a shaft: a pressure outside makes it carry p r2 / r1 there.
    constexpr int n = 12;
    const double r1 = 3.0, r2 = 4.0;
    std::string points = "[", elements = "[", inner = "[", outer = "[";
    for (int i = 0; i <= n; ++i) {
        const double angle = 0.5 * std::numbers::pi * i / n;
        const auto add = [&](const char* name, double r) {
            points += std::string(points.size() > 1 ? "," : "") + R"({"id": ")" + name + std::to_string(i) +
                      R"(", "at": [)" + std::to_string(r * std::cos(angle)) + "," +
                      std::to_string(r * std::sin(angle)) + "]}";
        };
        add("i", r1);
        add("o", r2);
        const std::string k = std::to_string(i), next = std::to_string(i + 1), comma = i > 0 ? "," : "";
        inner += comma + "\"i" + k + "\"";
        outer += comma + "\"o" + k + "\"";
        if (i < n)
            elements += comma + R"({"id": ")" + k + R"(", "kind": "Q4", "points": ["i)" + k + R"(", "o)" + k +
                        R"(", "o)" + next + R"(", "i)" + next + R"("], "region": "ring"})";
    }
    const std::string curves = R"([{"id": "shaft", "kind": "edges", "points": )" + inner +
                               R"(], "support": {"fixed": ["uy"], "axes": "local"}},
        {"id": "outer", "kind": "edges", "points": )" +
                               outer + R"(]},
        {"id": "foot", "kind": "edges", "points": ["i0", "o0"], "support": "symmetry"},
        {"id": "head", "kind": "edges", "points": ["i12", "o12"], "support": "symmetry"}])";
    points += "]", elements += "]";
    const auto [model, results,
                P] = solved({.points = points,
                             .curves = curves,
                             .regions = R"([{"id": "ring", "material": "m", "thickness": 0.4}])",
                             .elements = elements,
                             .load_case = R"(, "curves": [{"curve": "outer", "kind": "pressure", "value": 6}])"});
    for (std::size_t i = 0; i < model.points.size(); i += 2) // no inner node moves
        CHECK(P.displacement(NodeId(i)).norm() < 1e-9);
    // Half the ring's height of pressure goes to the shaft and to the two cuts: fx of all is p r2 t.
    CHECK(P.reaction(everywhere(model)).x() == doctest::Approx(6.0 * r2 * thickness).epsilon(0.01));
}

TEST_CASE("A thick cylinder keeps its axis, and its ring stress is that of its mean radius")
{
    // One ring of Q4 from r = 3 to 7 between smooth plates: p = 5 inside. The mean ring stress is p a / (b - a).
    constexpr std::string_view points =
        R"([{"id": "A", "at": [3, 0]}, {"id": "B", "at": [5, 0]}, {"id": "C", "at": [7, 0]},
        {"id": "D", "at": [3, 2]}, {"id": "E", "at": [5, 2]}, {"id": "F", "at": [7, 2]}])";
    constexpr std::string_view curves =
        R"([{"id": "bottom", "kind": "edges", "points": ["A", "B", "C"], "support": "roller"},
            {"id": "inside", "kind": "edges", "points": ["A", "D"]}])";
    const auto [model, results,
                P] = solved({.analysis = "axisymmetric",
                             .points = points,
                             .curves = curves,
                             .regions = R"([{"id": "web", "material": "m"}, {"id": "rib", "material": "m"}])",
                             .load_case = R"(, "curves": [{"curve": "inside", "kind": "pressure", "value": 5}])"});
    double ring = 0.0;
    for (std::size_t e = 0; e < 2; ++e)
        P.at_integration_points(ElementId(e),
                                [&](const Eigen::Vector2d&, const PlaneStress& s) { ring += s.sz / 8.0; });
    CHECK(ring == doctest::Approx(5.0 * 3.0 / 4.0).epsilon(0.02));
    CHECK(P.energy() == doctest::Approx(0.5 * 5.0 * 2.0 * std::numbers::pi * 3.0 * 2.0 * 0.5 *
                                        (P.displacement(A).x() + P.displacement(D).x()))
                            .epsilon(1e-10));
}

TEST_CASE("A cut finds N, V and M of a cantilever: V is the tip's force, M its moment there")
{
    const auto [model, results,
                P] = solved({.load_case = R"(, "points": [{"point": "C", "fy": -6}, {"point": "F", "fx": 9}])"});
    // Drawn upwards x' = x. At any x the part to the right has N = 9, V = 6 (along -y' on the face +x' : -V' = ..).
    for (const double x : {1.0, 3.0, 4.5}) {
        CAPTURE(x);
        const CutForces up = P.forces({{x, -1.0}, {x, 3.0}}), down = P.forces({{x, 3.0}, {x, -1.0}});
        CHECK(up.N == doctest::Approx(down.N).epsilon(1e-12));
        CHECK(up.V == doctest::Approx(down.V).epsilon(1e-12));
        CHECK(up.M == doctest::Approx(-down.M).epsilon(1e-12));
    }
    const CutForces mid = P.forces({{5.0, 0.0}, {5.0, 2.0}});
    CHECK(mid.V == doctest::Approx(6.0).epsilon(1e-9));
}

TEST_CASE("A uniform pull crosses a slanted cut as its projection says")
{
    const double q = 13.0;
    const auto [model, results,
                P] = solved(narrowing(R"(, "curves": [{"curve": "right", "kind": "traction", "qx": 13}])"));
    const Cut slanted{{2.0, 0.0}, {3.5, 2.0}};
    const Eigen::Vector2d n = slanted.normal(), t = slanted.along();
    const CutForces forces = P.forces(slanted);
    CHECK(forces.N == doctest::Approx(q * n.x() * n.x() * slanted.length() * thickness).epsilon(1e-11));
    CHECK(forces.V == doctest::Approx(-q * n.x() * t.x() * slanted.length() * thickness).epsilon(1e-11));
    CHECK(std::abs(forces.M) < 1e-10);
}

TEST_CASE("A place between nodes is found in its element, and one beyond its straight sides in none")
{
    const auto [model, results,
                P] = solved(narrowing(R"(, "curves": [{"curve": "right", "kind": "traction", "qx": 13}])"));
    const auto at = results.locator().find({5.5, 0.75});
    REQUIRE(at.size() == 1);
    CHECK(P.displacement(at[0]).x() == doctest::Approx(13.0 / E * 5.5).epsilon(1e-12));
    CHECK(results.locator().find({3.0, 1.0}).size() == 2);
    CHECK(results.locator().find({7.2, 1.0}).empty());
    CHECK(results.locator().find({17.0, 1.0}).empty());
}

TEST_CASE("A body that supports leave free is refused with the way in which its region moves")
{
    constexpr std::string_view can_move = "the structure can move without strain: the part in ";
    const auto with = [](std::string_view curves) { return refusal(PlaneText{.curves = curves}); };
    CHECK(with(R"([{"id": "bottom", "kind": "edges", "points": ["A", "B", "C"], "support": "roller"}])") ==
          std::string(can_move) + "web and rib moves along x; add a support against it");
    CHECK(with("[]") == std::string(can_move) + "web and rib moves along x; add a support against it\n" +
                            std::string(can_move) + "web and rib moves along y; add a support against it\n" +
                            std::string(can_move) + "web and rib turns about (3.5, 1) mm; add a support against it");
    CHECK(refusal(PlaneText{.points = R"([{"id": "A", "at": [0, 0], "support": "pin"}, {"id": "B", "at": [3, 0]},
        {"id": "C", "at": [7, 0]}, {"id": "D", "at": [0, 2]}, {"id": "E", "at": [3, 2]}, {"id": "F", "at": [7, 2]}])",
                            .curves = "[]"}) ==
          std::string(can_move) + "web and rib turns about (0, 0) mm; add a support against it");
}

TEST_CASE("Parts that meet in one node turn about it")
{
    const PlaneText hinged{.curves = R"([{"id": "left", "kind": "edges", "points": ["D", "A"], "support": "fixed"}])",
                           .elements = R"([{"id": "1", "kind": "Q4", "points": ["A", "B", "E", "D"], "region": "web"},
                               {"id": "2", "kind": "T3", "points": ["B", "C", "F"], "region": "rib"}])"};
    CHECK(refusal(hinged) ==
          "the structure can move without strain: the part in rib turns about (3, 0) mm; add a support against it");
}

TEST_CASE("A shape that no integration point feels is refused and named")
{
    // One Q8 with 2 x 2 points has two modes without strain beside its rigid motions; a roller and a pin stop none.
    const PlaneText alone{
        .points = R"([{"id": "A", "at": [0, 0], "support": "pin"}, {"id": "B", "at": [3, 0], "support": "roller"},
            {"id": "C", "at": [3, 2]}, {"id": "D", "at": [0, 2]}, {"id": "ab", "at": [1.5, 0]}, {"id": "bc", "at": [3, 1]},
            {"id": "cd", "at": [1.5, 2]}, {"id": "da", "at": [0, 1]}])",
        .curves = "[]",
        .regions = R"([{"id": "web", "material": "m", "thickness": 0.4, "mesh": {"formulation": "reduced"}}])",
        .elements =
            R"([{"id": "1", "kind": "Q8", "points": ["A", "B", "C", "D", "ab", "bc", "cd", "da"], "region": "web"}])"};
    CHECK(refusal(alone).find("elements in web deform so that no integration point feels it") != std::string::npos);
}

TEST_CASE("A body goes where the springs that alone hold it settle, to the digits that are told")
{
    const Eigen::Vector2d settled(0.3, -0.2);
    const auto on_points = [](const std::string& k) {
        const std::string held = R"(, "support": {"springs": {"ux": )" + k + R"(, "uy": )" + k + "}}";
        return R"([{"id": "A", "at": [0, 0])" + held + R"(}, {"id": "B", "at": [3, 0]}, {"id": "C", "at": [7, 0])" +
               held + R"(}, {"id": "D", "at": [0, 2]}, {"id": "E", "at": [3, 2]}, {"id": "F", "at": [7, 2]}])";
    };
    const auto on_curve = [](const std::string& k) {
        return R"([{"id": "left", "kind": "edges", "points": ["D", "A"], "support": {"springs": {"ux": )" + k +
               R"(, "uy": )" + k + R"(}, "axes": "local"}}])";
    };
    const auto require_truth = [&settled](const PlaneText& text) {
        const Solved moved = solved(text);
        double digits = 8.0; // of what is not warned of
        for (const Fault& warning : moved.results.warnings()) {
            CHECK(warning.kind == FaultKind::InaccurateBody);
            digits = std::stod(warning.arguments.at(1));
        }
        for (const NodeId node : everywhere(moved.model))
            CHECK((moved.first.displacement(node) - settled).norm() <= std::pow(10.0, -digits));
        return digits;
    };
    for (const char* const k : {"2e4", "2e2", "2", "2e-2"}) {
        CAPTURE(k);
        const std::string points = on_points(k), curves = on_curve(k);
        CHECK(require_truth({.points = points,
                             .curves = "[]",
                             .load_case = R"(, "settlements": [{"point": "A", "ux": 0.3, "uy": -0.2},
                                 {"point": "C", "ux": 0.3, "uy": -0.2}])"}) == 8.0);
        // along the curve, which goes down, and to its left
        CHECK(require_truth({.curves = curves,
                             .load_case = R"(, "settlements": [{"curve": "left", "ux": 0.2, "uy": 0.3}])"}) == 8.0);
    }
    const std::string soft = on_points("2e-7");
    CHECK(require_truth(
              {.points = soft, .curves = "[]", .load_case = R"(, "settlements": [{"point": "A", "ux": 0.3, "uy": -0.2},
                             {"point": "C", "ux": 0.3, "uy": -0.2}])"}) < 8.0);
}

TEST_CASE("Elements that are one moved along share their stiffness, but not around an axis")
{
    const auto groups = [](const std::string& analysis, const std::string& thickness) {
        const PlaneModel model =
            examine_plane_model(
                R"({"cremona": 1, "analysis": ")" + analysis +
                R"(", "units": {"length": "m", "force": "N"}, "materials": [{"id": "m", "E": 1, "nu": 0.3}],
            "points": [{"id": "A", "at": [0.1, 0]}, {"id": "B", "at": [0.4, 0]}, {"id": "C", "at": [0.7, 0]},
                       {"id": "D", "at": [1.2, 0]}, {"id": "a", "at": [0.1, 0.3]}, {"id": "b", "at": [0.4, 0.3]},
                       {"id": "c", "at": [0.7, 0.3]}, {"id": "d", "at": [1.2, 0.3]}],
            "elements": [{"id": "1", "kind": "Q4", "points": ["A", "B", "b", "a"], "region": "r"},
                         {"id": "2", "kind": "Q4", "points": ["B", "C", "c", "b"], "region": "r"},
                         {"id": "3", "kind": "Q4", "points": ["C", "D", "d", "c"], "region": "r"}],
            "regions": [{"id": "r", "material": "m")" +
                thickness + R"(}], "load_cases": []})")
                .model;
        const PlaneStructure structure(model);
        std::vector<std::uint32_t> found;
        for (std::size_t e = 0; e < 3; ++e) found.push_back(structure.element(ElementId(e)).stiffness_group());
        return found;
    };
    CHECK(groups("plane_stress", R"(, "thickness": 1)") == std::vector<std::uint32_t>{1, 1, 3});
    CHECK(groups("axisymmetric", "") == std::vector<std::uint32_t>{0, 0, 0});
}
