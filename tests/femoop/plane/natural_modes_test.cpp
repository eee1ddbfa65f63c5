#include "femoop/plane/analysis/natural_modes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

#include "femoop/io/plane/modes_output.h"
#include "femoop/io/plane/plane_file.h"
#include "femoop/io/plane/plane_verify.h"
#include "tests/femoop/plane/plane_text.h"

using namespace femoop;
using namespace femoop::plane;

namespace {

using std::numbers::pi;

/// A rectangle of Q4, from (x0, 0); its sides are the curves bottom, right, top, left.
struct Grid {
    double x0 = 0.0, width = 1.0, height = 1.0;
    int nx = 1, ny = 1;
    std::string analysis = "plane_stress";
    std::string material = R"("E": 210e9, "nu": 0, "density": 7800)";
    std::string bottom{}, right{}, top{}, left{}; ///< what follows their points: `, "support": "fixed"`
    std::string formulation = "standard";

    PlaneModel model() const
    {
        std::ostringstream text;
        text.precision(17);
        text << R"({"cremona": 1, "units": {"length": "m", "force": "N"}, "analysis": ")" << analysis
             << R"(", "materials": [{"id": "m", )" << material << R"(}], "mesh": {"formulation": ")" << formulation
             << R"("}, "regions": [{"id": "plate", "material": "m")"
             << (analysis == "axisymmetric" ? "" : R"(, "thickness": 0.02)") << R"(}], "points": [)";
        for (int j = 0; j <= ny; ++j)
            for (int i = 0; i <= nx; ++i)
                text << (i + j > 0 ? "," : "") << R"({"id": ")" << name(i, j) << R"(", "at": [)" << x0 + width * i / nx
                     << "," << height * j / ny << "]}";
        text << R"(], "curves": [)" << side("bottom", 0, 0, 1, 0, nx, bottom) << ","
             << side("right", nx, 0, 0, 1, ny, right) << "," << side("top", 0, ny, 1, 0, nx, top) << ","
             << side("left", 0, 0, 0, 1, ny, left) << R"(], "elements": [)";
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i)
                text << (i + j > 0 ? "," : "") << R"({"id": "e)" << name(i, j) << R"(", "kind": "Q4", "points": [")"
                     << name(i, j) << "\",\"" << name(i + 1, j) << "\",\"" << name(i + 1, j + 1) << "\",\""
                     << name(i, j + 1) << R"("], "region": "plate"})";
        text << R"(], "load_cases": []})";
        return read_plane_model(text.str());
    }

private:
    static std::string name(int i, int j) { return std::to_string(i) + "_" + std::to_string(j); }
    static std::string side(const std::string& id, int i, int j, int di, int dj, int n, const std::string& more)
    {
        std::string text = R"({"id": ")" + id + R"(", "kind": "edges", "points": [)";
        for (int k = 0; k <= n; ++k) text += (k > 0 ? ",\"" : "\"") + name(i + k * di, j + k * dj) + "\"";
        return text + "]" + more + "}";
    }
};

const std::string slides = R"(, "support": {"fixed": ["uy"]})", held_along = R"(, "support": {"fixed": ["ux"]})";

FaultKind refusal(const PlaneModel& model, std::optional<std::size_t> wanted = {})
{
    try {
        natural_modes(model, wanted);
    } catch (const ModelError& error) {
        return error.faults().front().kind;
    }
    return FaultKind::FileEmpty;
}

} // namespace

TEST_CASE("A bar of linear elements vibrates as its difference equation says")
{
    // omega^2 = 6 E / (rho h^2) (1 - cos kh) / (2 + cos kh), k = (2 i - 1) pi / 2L: fixed at one end, free at the other
    constexpr int n = 40;
    constexpr double L = 3.0, h = L / n, E = 210e9, rho = 7800.0;
    const Grid bar{.width = L, .height = 0.1, .nx = n, .bottom = slides, .top = slides, .left = held_along};
    const NaturalModes found = natural_modes(bar.model(), 6);
    REQUIRE(found.modes.size() == 6);
    CHECK(found.warnings.empty());
    CHECK(found.total_mass == doctest::Approx(rho * L * 0.1 * 0.02).epsilon(1e-12));
    for (int i = 0; i < 6; ++i) {
        const double c = std::cos((2 * i + 1) * pi / (2.0 * L) * h);
        const double omega = std::sqrt(6.0 * E / (rho * h * h) * (1.0 - c) / (2.0 + c));
        const NaturalMode& mode = found.modes[static_cast<std::size_t>(i)];
        CHECK(mode.omega == doctest::Approx(omega).epsilon(1e-9));
        CHECK(mode.frequency() == doctest::Approx(omega / (2.0 * pi)).epsilon(1e-9));
        CHECK(mode.count == static_cast<std::size_t>(i + 1));
        CHECK(mode.effective_mass.y() < 1e-9);
    }
    // Of a continuous bar the first mode carries 8 / pi^2 of the mass, with the participation 4 / pi.
    CHECK(found.modes[0].effective_mass.x() == doctest::Approx(8.0 / (pi * pi) * found.total_mass).epsilon(1e-3));
    CHECK(found.modes[0].participation.x() == doctest::Approx(4.0 / pi).epsilon(1e-3));
    CHECK(found.modes[0].shape.back().x() == doctest::Approx(1.0));
}

TEST_CASE("A plate that floats has three motions of 0 Hz, which carry all of its mass")
{
    const NaturalModes found = natural_modes(Grid{.width = 2.0, .nx = 8, .ny = 4}.model(), 5);
    Eigen::Vector2d carried = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(found.modes[i].omega == 0.0);
        CHECK(found.modes[i].count == 3);
        carried += found.modes[i].effective_mass;
    }
    CHECK(carried.x() == doctest::Approx(found.total_mass).epsilon(1e-9));
    CHECK(carried.y() == doctest::Approx(found.total_mass).epsilon(1e-9));
    CHECK(found.modes[3].omega > 0.0);
    CHECK(found.modes[3].effective_mass.norm() < 1e-9 * found.total_mass);
}

TEST_CASE("Modes of a square come in pairs, and the count tells both")
{
    const std::string fixed = R"(, "support": "fixed")";
    const Grid square{.nx = 9, .ny = 9, .bottom = fixed, .right = fixed, .top = fixed, .left = fixed};
    const NaturalModes found = natural_modes(square.model(), 1);
    REQUIRE(found.modes.size() == 1);
    CHECK(found.modes[0].count == 2);
    const NaturalModes both = natural_modes(square.model(), 2);
    CHECK(both.modes[1].omega == doctest::Approx(both.modes[0].omega).epsilon(1e-9));
}

TEST_CASE("A slender cantilever swings as a beam does")
{
    // omega = 1.875104^2 sqrt(E I / (rho A L^4)) [Bathe1996], with elements that bend without locking
    constexpr double L = 10.0, h = 0.2;
    const Grid beam{
        .width = L, .height = h, .nx = 60, .ny = 2, .left = R"(, "support": "fixed")", .formulation = "incompatible"};
    const double omega = std::pow(1.8751040687, 2) * std::sqrt(210e9 * h * h / 12.0 / 7800.0) / (L * L);
    CHECK(natural_modes(beam.model(), 1).modes[0].omega == doctest::Approx(omega).epsilon(2e-3));
}

TEST_CASE("A thin ring turns its section with sqrt(E / 2 rho) / R and breathes with sqrt(E / rho) / R")
{
    // turning: omega^2 = E I / (rho (I + I) R^2) of a square section
    const Grid ring{.x0 = 5.0, .width = 0.01, .height = 0.01, .analysis = "axisymmetric"};
    const NaturalModes found = natural_modes(ring.model(), 3);
    CHECK(found.modes[0].omega == 0.0); // along the axis
    CHECK(found.modes[0].effective_mass.y() == doctest::Approx(found.total_mass).epsilon(1e-9));
    CHECK(found.modes[1].omega == doctest::Approx(std::sqrt(0.5 * 210e9 / 7800.0) / 5.005).epsilon(1e-5));
    CHECK(found.modes[2].omega == doctest::Approx(std::sqrt(210e9 / 7800.0) / 5.005).epsilon(1e-5));
    CHECK(found.total_mass == doctest::Approx(7800.0 * 2.0 * pi * 5.005 * 1e-4).epsilon(1e-12));
}

TEST_CASE("A finer mesh is slower, and every solver finds the same modes")
{
    const auto first = [](int n, SolverKind solver) {
        const Grid wall{.width = 2.0, .height = 1.0, .nx = 2 * n, .ny = n, .bottom = R"(, "support": "fixed")"};
        return natural_modes(wall.model(), 3, {.solver = solver}).modes;
    };
    const auto usual = first(8, SolverKind::Automatic);
    CHECK(first(16, SolverKind::Automatic)[0].omega < usual[0].omega);
    for (const SolverKind solver : available_solvers())
        for (std::size_t i = 0; i < 3; ++i)
            CHECK(first(8, solver)[i].omega == doctest::Approx(usual[i].omega).epsilon(1e-9));
}

TEST_CASE("Vibrations that there are not are refused in words")
{
    Grid massless{.left = R"(, "support": "fixed")"};
    CHECK(refusal(massless.model(), 5) == FaultKind::TooFewModes); // two nodes are free: 4 modes
    CHECK(refusal(massless.model(), 4) == FaultKind::FileEmpty);
    CHECK(natural_modes(massless.model()).modes.size() == 4); // the usual number, or all
    massless.material = R"("E": 1e300, "nu": 0, "density": 1e-300)";
    CHECK(refusal(massless.model()) == FaultKind::StiffnessBeyondRange);
    massless.material = R"("E": 210e9, "nu": 0, "density": 1e307)";
    CHECK(refusal(massless.model()) == FaultKind::FileEmpty); // slow, and yet a number
    massless.material = R"("E": 210e9, "nu": 0)";
    CHECK(refusal(massless.model()) == FaultKind::NothingHasMass);
}

TEST_CASE("A region without density goes along, and this is told")
{
    const PlaneText text{
        .materials = R"([{"id": "m", "E": 71e3, "nu": 0.27, "density": 2.7e-9}, {"id": "n", "E": 71e3, "nu": 0.27}])",
        .regions = R"([{"id": "web", "material": "m", "thickness": 0.4},
                                        {"id": "rib", "material": "n", "thickness": 0.4}])"};
    const NaturalModes found = natural_modes(read_plane_model(text.text()));
    REQUIRE(found.warnings.size() == 1);
    CHECK(message(found.warnings[0]) ==
          "regions rib have no mass, since material n has no density; give it one if they have any");
    CHECK(found.modes.size() == 4); // both directions of the two nodes of the web that are free
}

TEST_CASE("A file expects frequencies")
{
    const Grid bar{.width = 3.0, .height = 0.1, .nx = 4, .bottom = slides, .top = slides, .left = held_along};
    PlaneModel model = bar.model();
    const double second = natural_modes(model, 2).modes[1].frequency();
    PlaneExpected check;
    check.quantity = PlaneQuantity::Frequency;
    check.analysis = ExpectedAnalysis::Modal;
    check.rank = 2;
    check.value = second;
    model.expected.push_back(check);
    check.value = 1.01 * second;
    model.expected.push_back(check);
    CHECK(n_modes_needed(model) == 2);
    const auto outcomes = verify(model, {.modes = natural_modes(model, n_modes_needed(model))});
    CHECK(outcomes[0].verdict == Verdict::Passed);
    CHECK(outcomes[1].verdict == Verdict::Failed);
    CHECK(outcomes[0].what == "modal frequency 2");
}
