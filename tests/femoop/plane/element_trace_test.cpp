#include "femoop/plane/analysis/element_trace.h"

#include <doctest/doctest.h>

#include <string>

#include "femoop/io/plane/element_trace_output.h"
#include "femoop/io/plane/plane_file.h"

using namespace femoop::plane;
using doctest::Approx;

namespace {

/// A unit square of one element, held at its left side.
PlaneModel square(const std::string& analysis, const std::string& more = "")
{
    return examine_plane_model(
               R"({"cremona": 1, "analysis": ")" + analysis +
               R"(", "units": {"length": "m", "force": "N"}, "materials": [{"id": "m", "E": 1, "nu": 0.3}],
        "points": [{"id": "A", "at": [0, 0], "support": "fixed"}, {"id": "B", "at": [1, 0]}, {"id": "C", "at": [1, 1]},
                   {"id": "D", "at": [0, 1], "support": {"fixed": ["ux"], "angle": 30}}],
        "elements": [{"id": "e", "kind": "Q4", "points": ["A", "B", "C", "D"], "region": "r"}],
        "curves": [{"id": "right", "kind": "edges", "points": ["B", "C"]}],
        "regions": [{"id": "r", "material": "m", "thickness": 1)" +
               more +
               R"(}], "load_cases": [{"id": "P", "curves": [{"curve": "right", "kind": "traction", "qx": 3}]}]})")
        .model;
}

} // namespace

TEST_CASE("The stiffness of a square is the sum of its points', and that of the textbooks")
{
    const ElementTrace traced = trace(square("plane_stress"), ElementId(0U));
    REQUIRE(traced.points.size() == 4);
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(8, 8);
    for (const ElementTrace::Point& point : traced.points) {
        CHECK(point.J.isApprox(0.5 * Eigen::Matrix2d::Identity()));
        CHECK(point.N.sum() == Approx(1.0));
        CHECK(point.part.isApprox(point.B.transpose() * traced.D * point.B * point.weight * point.area * point.depth));
        sum += point.part;
    }
    CHECK(sum.isApprox(traced.stiffness));
    const double nu = 0.3; // k11 and k12 of a square [Hughes2000]: by hand from the integrals of dN/dx dN/dx
    CHECK(traced.stiffness(0, 0) == Approx((0.5 - nu / 6.0) / (1.0 - nu * nu)));
    CHECK(traced.stiffness(0, 1) == Approx((1.0 + nu) / 8.0 / (1.0 - nu * nu)));
    Eigen::VectorXd turn(8);
    turn << 0, 0, 0, 1, -1, 1, -1, 0; // (-y, x)
    CHECK((traced.stiffness * turn).norm() < 1e-14);
}

TEST_CASE("Rows of what is held have no place, and those of a turned support are in its axes")
{
    const ElementTrace traced = trace(square("plane_strain"), ElementId(0U));
    CHECK(traced.equations == std::vector<int>{0, 0, 1, 2, 3, 4, 0, 5});
    CHECK(traced.components == std::vector<std::string>{"ex", "ey", "ez", "gxy"});
    REQUIRE(traced.to_nodes.rows() == 8);
    CHECK(traced.to_nodes.topLeftCorner(6, 6).isApprox(traced.stiffness.topLeftCorner(6, 6)));
    CHECK(traced.to_nodes.bottomRightCorner(2, 2).trace() == Approx(traced.stiffness.bottomRightCorner(2, 2).trace()));
    REQUIRE(traced.loads.size() == 1);
    Eigen::VectorXd f(8);
    f << 0, 0, 1.5, 0, 1.5, 0, 0, 0;
    CHECK(traced.loads.front().f.isApprox(f));
}

TEST_CASE("What incompatible modes take is told, and all is in the text and in the JSON")
{
    const PlaneModel model = square("plane_stress", R"(, "mesh": {"formulation": "incompatible"})");
    const ElementTrace traced = trace(model, ElementId(0U));
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(8, 8);
    for (const ElementTrace::Point& point : traced.points) sum += point.part;
    CHECK(sum(0, 0) > traced.stiffness(0, 0));
    const std::string text = trace_text(traced, model.units);
    CHECK(text.find("less what the incompatible modes take") != std::string::npos);
    CHECK(text.find("none: held by a support") != std::string::npos);
    CHECK(trace_json(traced, model.units).find(R"("formulation": "incompatible")") != std::string::npos);
}
