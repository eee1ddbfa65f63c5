#include "femoop/methods/mohr/state.h"

#include <doctest/doctest.h>

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "femoop/methods/mohr/typed_components.h"

using namespace femoop::mohr;
using doctest::Approx;

TEST_SUITE_BEGIN("femoop mohr");

namespace {

constexpr double E = 210e3, nu = 0.28;
constexpr std::array<std::string_view, 3> names{"SX", "SY", "TXY"};

std::variant<Components, femoop::Fault> typed(const std::vector<std::string>& texts)
{
    return parse_components(texts, names, "--stress", femoop::dimension::stress);
}

std::string refusal(const std::vector<std::string>& texts)
{
    const auto found = typed(texts);
    const auto* fault = std::get_if<femoop::Fault>(&found);
    return fault != nullptr ? femoop::message(*fault) : "";
}

} // namespace

TEST_CASE("Plane strain has nu times the sum of both stresses square to the plane")
{
    State state = plane_state(Kind::PlaneStrain, 30.0, 50.0, 7.0);
    state.nu = nu;
    CHECK(in_space(state)->z == Approx(nu * 80.0));
    CHECK(in_space(plane_state(Kind::PlaneStress, 30.0, 50.0, 7.0))->z == 0.0);
    CHECK_FALSE(in_space(plane_state(Kind::Inertia, 30.0, 50.0, 7.0)));
}

TEST_CASE("A strain holds half of gamma and second moments of area hold minus the product")
{
    CHECK(plane(plane_state(Kind::Strain, 1.0, 2.0, 6.0)).xy == 3.0);
    CHECK(plane(plane_state(Kind::Inertia, 1.0, 2.0, 6.0)).xy == -6.0);
    for (const Kind kind : {Kind::PlaneStress, Kind::Strain, Kind::Inertia})
        CHECK(given_shear(kind, plane(plane_state(kind, 1.0, 2.0, 6.0)).xy) == 6.0);
}

TEST_CASE("A free surface carries no stress across it and its strains in space give back the plane's stresses")
{
    State state = plane_state(Kind::Strain, 400e-6, -150e-6, 230e-6);
    state.E = E;
    state.nu = nu;
    const SpaceState from_space = stress(*in_space(state), {E, nu});
    const SpaceState on_surface = *stress(state);
    CHECK(std::abs(from_space.z) < 1e-12);
    CHECK(from_space.x == Approx(on_surface.x));
    CHECK(from_space.y == Approx(on_surface.y));
    CHECK(from_space.xy == Approx(on_surface.xy));
    CHECK(on_surface.xy == Approx(E / (2.0 * (1.0 + nu)) * 230e-6));
}

TEST_CASE("Numbers of one unit keep their digits and others are brought to the first unit")
{
    const auto one = std::get<Components>(typed({"120 MPa", "-80.1 MPa", "0"}));
    CHECK(one.values == std::vector{120.0, -80.1, 0.0});
    CHECK(one.unit == "MPa");
    const auto two = std::get<Components>(typed({"1 ksi", "6.894757293168361 MPa", "-1000 psi"}));
    CHECK(two.unit == "ksi");
    CHECK(two.values[1] == Approx(1.0));
    CHECK(two.values[2] == Approx(-1.0));
    CHECK(std::get<Components>(typed({"1", "+2.5", "-3e2"})).unit.empty());
}

TEST_CASE("What is no stress is refused with its component and a remedy")
{
    CHECK(refusal({"1 MPa", "2", "3 MPa"}) ==
          "--stress SY: \"2\" has no unit; write \"12.5 N/mm^2\" for example, or a number without quotation marks");
    CHECK(refusal({"1 kN", "2", "3"}).find("--stress SX: \"1 kN\" measures force, wanted stress") == 0);
    CHECK(refusal({"1", "2", "x"}).find("--stress TXY: \"x\" does not begin with a number") == 0);
    CHECK(refusal({"1", "nan", "3"}).find("--stress SY: \"nan\" does not begin with a number") == 0);
    const std::vector<std::string> strains{"1", "2", "3 kN"};
    const auto plain = parse_components(strains, names, "--strain", femoop::dimension::none);
    REQUIRE(std::holds_alternative<femoop::Fault>(plain));
    CHECK(femoop::message(std::get<femoop::Fault>(plain)).find("--strain TXY: \"3 kN\" measures force") == 0);
    CHECK(
        refusal({"1e300", "2", "3"}) ==
        "--stress SX: \"1e300\" is beyond the range of numbers; write one that is nearer to 1, or 0 where nothing is meant");
}

TEST_CASE("No section has a negative principal second moment")
{
    CHECK(is_possible(plane_state(Kind::Inertia, 2900.0, 5600.0, -3000.0)));
    CHECK(is_possible(plane_state(Kind::Inertia, 3.0, 12.0, 6.0))); // a slender one, along a line
    CHECK(!is_possible(plane_state(Kind::Inertia, 1.0, 1.0, 5.0)));
    CHECK(!is_possible(plane_state(Kind::Inertia, -3.0, 4.0, 0.0)));
    CHECK(is_possible(plane_state(Kind::PlaneStress, 1.0, 1.0, 5.0)));
}

TEST_SUITE_END();
