#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "femoop/io/plane/plane_file.h"
#include "femoop/plane/analysis/plane_analysis.h"
#include "femoop/plane/analysis/result_reader.h"

using namespace femoop;
using namespace femoop::plane;

namespace {

constexpr double inner = 3.0, outer = 7.0, pressure = 5.0, modulus = 71.0e3;

/// A disc of rings between smooth plates, pressed from inside: rows of the elements of one kind.
std::string rings(std::string_view kind, std::string_view formulation, double nu, int n)
{
    const bool is_quadratic = kind == "Q8";
    std::string points, elements;
    const auto add = [&](const std::string& id, double x, double y) {
        points += (points.empty() ? "" : ",") + std::string(R"({"id": ")") + id + R"(", "at": [)" + std::to_string(x) +
                  "," + std::to_string(y) + "]}";
    };
    const double step = (outer - inner) / n, height = 0.5;
    for (int i = 0; i <= n; ++i) {
        const std::string k = std::to_string(i);
        add("b" + k, inner + i * step, 0.0);
        add("t" + k, inner + i * step, height);
        if (is_quadratic) add("m" + k, inner + i * step, 0.5 * height);
        if (i == n) break;
        if (is_quadratic) {
            add("bb" + k, inner + (i + 0.5) * step, 0.0);
            add("tt" + k, inner + (i + 0.5) * step, height);
        }
        const std::string next = std::to_string(i + 1);
        const std::string middles = R"(, "bb)" + k + R"(", "m)" + next + R"(", "tt)" + k + R"(", "m)" + k + "\"";
        elements += (i > 0 ? "," : "") + std::string(R"({"id": ")") + k + R"(", "kind": ")" + std::string(kind) +
                    R"(", "points": ["b)" + k + R"(", "b)" + next + R"(", "t)" + next + R"(", "t)" + k + "\"" +
                    (is_quadratic ? middles : "") + R"(], "region": "disc"})";
    }
    std::string bottom, top;
    for (int i = 0; i <= n; ++i) {
        bottom += (i > 0 ? ",\"b" : "\"b") + std::to_string(i) + "\"";
        top += (i > 0 ? ",\"t" : "\"t") + std::to_string(i) + "\"";
    }
    return R"({"cremona": 1, "analysis": "axisymmetric", "units": {"length": "mm", "force": "N"}, "mesh": {"formulation": ")" +
           std::string(formulation) + R"("}, "materials": [{"id": "m", "E": 71e3, "nu": )" + std::to_string(nu) +
           R"(}], "points": [)" + points + R"(], "curves": [{"id": "bottom", "kind": "edges", "points": [)" + bottom +
           R"(], "support": "roller"}, {"id": "top", "kind": "edges", "points": [)" + top +
           R"(], "support": "roller"}, {"id": "inside", "kind": "edges", "points": ["b0", "t0"]}],
           "regions": [{"id": "disc", "material": "m"}], "elements": [)" +
           elements +
           R"(], "load_cases": [{"id": "P", "curves": [{"curve": "inside", "kind": "pressure", "value": 5}]}]})";
}

/// Lame: u(r) = A r + B / r in plane strain.
double exact_displacement(double r, double nu)
{
    const double a2 = inner * inner, b2 = outer * outer, c = pressure * a2 / (b2 - a2);
    return (1.0 + nu) / modulus * c * ((1.0 - 2.0 * nu) * r + b2 / r);
}

double found_over_exact(std::string_view kind, std::string_view formulation, double nu, int n)
{
    const PlaneModel model = read_plane_model(rings(kind, formulation, nu, n));
    const PlaneResults results = analyse(model);
    return results[CaseId(0)].displacement(NodeId(0)).x() / exact_displacement(inner, nu);
}

} // namespace

TEST_CASE("A material that keeps its volume locks the standard Q4, and neither B-bar nor the reduced Q8")
{
    const double nu = 0.4999;
    CHECK(found_over_exact("Q4", "standard", nu, 10) < 0.9);
    CHECK(found_over_exact("Q4", "b_bar", nu, 10) == doctest::Approx(1.0).epsilon(0.01));
    CHECK(found_over_exact("Q8", "reduced", nu, 10) == doctest::Approx(1.0).epsilon(0.001));
}

TEST_CASE("Each formulation comes nearer to Lame's cylinder with the square of the elements' size")
{
    for (const std::string_view formulation : {"standard", "b_bar"}) {
        CAPTURE(formulation);
        const double coarse = std::abs(found_over_exact("Q4", formulation, 0.3, 8) - 1.0);
        const double fine = std::abs(found_over_exact("Q4", formulation, 0.3, 16) - 1.0);
        CHECK(coarse / fine == doctest::Approx(4.0).epsilon(0.1));
    }
}

TEST_CASE("Recovered stresses of a cylinder are those of Lame inside and at the bore")
{
    const PlaneModel model = read_plane_model(rings("Q8", "standard", 0.3, 10));
    const PlaneResults results = analyse(model);
    const PlaneCase P = results[CaseId(0)];
    const double a2 = inner * inner, b2 = outer * outer, c = pressure * a2 / (b2 - a2);
    for (const double r : {3.0, 3.8, 5.1, 7.0}) {
        CAPTURE(r);
        const PlaneStress s = P.smoothed_stress(results.locator().find({r, 0.2}).front());
        CHECK(s.sx == doctest::Approx(c * (1.0 - b2 / (r * r))).epsilon(0.01).scale(pressure));
        CHECK(s.sz == doctest::Approx(c * (1.0 + b2 / (r * r))).epsilon(0.01));
    }
    CHECK(P.error_estimate() < 0.02);
}
