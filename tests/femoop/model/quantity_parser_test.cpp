#include "femoop/model/quantity/quantity_parser.h"

#include <doctest/doctest.h>

#include <string>
#include <variant>

#include "femoop/model/quantity/number_text.h"

using namespace femoop;

namespace {

constexpr Units m_kN{LengthUnit::m, ForceUnit::kN};
constexpr Units in_kip{LengthUnit::in, ForceUnit::kip};

double value(std::string_view text, Dimension wanted, const Units& units = m_kN)
{
    const auto parsed = parse_quantity(text, wanted, units);
    if (const Fault* const fault = std::get_if<Fault>(&parsed)) FAIL(message(*fault));
    return std::get<double>(parsed);
}

std::string refusal(std::string_view text, Dimension wanted)
{
    auto parsed = parse_quantity(text, wanted, m_kN);
    REQUIRE(std::holds_alternative<Fault>(parsed));
    Fault fault = std::get<Fault>(parsed);
    fault.arguments.front() = "here";
    return message(fault);
}

} // namespace

TEST_CASE("A metric quantity is the nearest double of its decimal")
{
    CHECK(value("205 GPa", dimension::stress) == 205e6);
    CHECK(value("1140 cm^4", dimension::second_moment) == 1140e-8);
    CHECK(value("-25 kN/m", dimension::force_per_length) == -25.0);
    CHECK(value("0.1 mm", dimension::length) == 0.0001);
    CHECK(value("7850 kg/m^3", dimension::density) == 7.85);
    CHECK(value("1.2e-5 1/K", dimension::expansion) == 1.2e-5);
    CHECK(value("12 MPa", dimension::stress, {LengthUnit::mm, ForceUnit::N}) == 12.0);
}

TEST_CASE("A customary quantity is its exact rational, rounded once")
{
    CHECK(value("1 ft", dimension::length) == 0.3048);
    CHECK(value("0.1 ft", dimension::length) == 0.03048); // the double 0.1 times 0.3048 is not
    CHECK(value("3 in", dimension::length) == 0.0762);
    CHECK(value("1 kip", dimension::force) == 4.4482216152605);
    CHECK(value("1 tf", dimension::force) == 9.80665);
    CHECK(value("250 kgf", dimension::force) == 2.4516625);
    CHECK(value("12 kip/ft", dimension::force_per_length, in_kip) == 1.0);
    CHECK(value("29000 ksi", dimension::stress, in_kip) == 29000.0);
    CHECK(value("490 lb", dimension::mass) == 0.2222602613); // 490 x 0.45359237 kg, in t
    CHECK(value("1 psi", dimension::stress, {LengthUnit::m, ForceUnit::N}) ==
          doctest::Approx(6894.757293168361).epsilon(1e-15));
}

TEST_CASE("Every unit of the format is known")
{
    for (const char* const unit : {"m", "mm", "cm", "km", "in", "ft"})
        CHECK(value(std::string("7 ") + unit, dimension::length) > 0.0);
    for (const char* const unit : {"N", "kN", "MN", "lbf", "kip", "tf", "kgf"})
        CHECK(value(std::string("7 ") + unit, dimension::force) > 0.0);
    for (const char* const unit : {"Pa", "kPa", "MPa", "GPa", "psi", "ksi"})
        CHECK(value(std::string("7 ") + unit, dimension::stress) > 0.0);
    for (const char* const unit : {"kg", "g", "t", "lb"}) CHECK(value(std::string("7 ") + unit, dimension::mass) > 0.0);
    for (const char* const unit : {"s", "ms"}) CHECK(value(std::string("7 1/") + unit, dimension::frequency) > 0.0);
    CHECK(value("7 Hz", dimension::frequency) == 7.0);
    CHECK(value("18 degF", dimension::temperature) == 10.0);
    CHECK(value("18 degC", dimension::temperature) == 18.0);
    CHECK(value("18 K", dimension::temperature) == 18.0);
    CHECK(value("90 deg", dimension::angle) == 1.5707963267948966);
    CHECK(value("0.25 rad", dimension::angle) == 0.25);
}

TEST_CASE("An angle that is counted in degrees keeps its degrees")
{
    CHECK(std::get<double>(parse_quantity("30 deg", dimension::angle, m_kN, AngleUnit::Degrees)) == 30.0);
    CHECK(std::get<double>(parse_quantity("3.141592653589793 rad", dimension::angle, m_kN, AngleUnit::Degrees)) ==
          180.0);
}

TEST_CASE("A rotational stiffness may leave its radians out")
{
    CHECK(value("4500 kN*m/rad", dimension::moment_per_angle) == 4500.0);
    CHECK(value("4500 kN*m", dimension::moment_per_angle) == 4500.0);
    CHECK(value("4500000 N*m", dimension::moment_per_angle) == 4500.0);
}

TEST_CASE("Blanks, signs and quotients are read as people write them")
{
    CHECK(value("  +12.5kN / m ", dimension::force_per_length) == 12.5);
    CHECK(value(".5 kN*m", dimension::moment) == 0.5);
    CHECK(value("2 kN/m/m", dimension::stress) == 2.0);
    CHECK(value("2 kN*m^-2", dimension::stress) == 2.0);
    CHECK(value("2 /K", dimension::expansion) == 2.0);
    CHECK(value("0.3", dimension::none) == 0.3);
}

TEST_CASE("Units are read as print has them, with dots and raised powers")
{
    CHECK(value("120.5 kN·m", dimension::moment) == 120.5);
    CHECK(value("120.5 kN ⋅ m", dimension::moment) == 120.5); // the dot operator
    CHECK(value("1140 cm⁴", dimension::second_moment) == 1140e-8);
    CHECK(value("12 N/mm²", dimension::stress) == 12e3);
    CHECK(value("7850 kg/m³", dimension::density) == 7.85);
    CHECK(value("90°", dimension::angle) == 1.5707963267948966);
    CHECK(value("18 °F", dimension::temperature) == 10.0);
    CHECK(value("1.2e-5 1/°C", dimension::expansion) == 1.2e-5);
}

TEST_CASE("A unit of the wrong dimension is refused with both dimensions")
{
    CHECK(refusal("5 kN·m", dimension::length) == "here: \"5 kN·m\" measures moment, wanted length, in m for example");
    CHECK(refusal("5 kN", dimension::stress) ==
          "here: \"5 kN\" measures force, wanted stress or force per area, in kN/m^2 for example");
    CHECK(refusal("5 kN*m", dimension::length) == "here: \"5 kN*m\" measures moment, wanted length, in m for example");
    CHECK(refusal("5 m", dimension::moment) == "here: \"5 m\" measures length, wanted moment, in kN·m for example");
    CHECK(refusal("5 rad", dimension::length) == "here: \"5 rad\" measures angle, wanted length, in m for example");
    CHECK(refusal("5 kN", dimension::density) ==
          "here: \"5 kN\" measures force, wanted density, in kg/m^3 for example");
    CHECK(refusal("5 kN^2*m", dimension::none) ==
          "here: \"5 kN^2*m\" measures force^2*length, wanted a plain number; take the unit away");
}

TEST_CASE("What is not a quantity is refused with a remedy")
{
    CHECK(refusal("", dimension::force) ==
          "here: \"\" does not begin with a number; write a number and its unit, like \"12.5 kN\"");
    CHECK(refusal("kN 5", dimension::force) ==
          "here: \"kN 5\" does not begin with a number; write a number and its unit, like \"12.5 kN\"");
    CHECK(refusal("nan kN", dimension::force).find("does not begin with a number") != std::string::npos);
    CHECK(refusal("inf kN", dimension::force).find("does not begin with a number") != std::string::npos);
    CHECK(refusal("5", dimension::force) ==
          "here: \"5\" has no unit; write \"12.5 kN\" for example, or a number without quotation marks");
    CHECK(refusal("12,5 kN", dimension::force) == "here: \"12,5 kN\" has a comma; write a decimal point");
    CHECK(refusal("5 kn", dimension::force) == "here: \"5 kn\": no unit \"kn\"; did you mean \"kN\"?");
    CHECK(refusal("5 furlong", dimension::length) ==
          "here: \"5 furlong\": no unit \"furlong\"; there are m mm cm km in ft, "
          "N kN MN lbf kip tf kgf, Pa kPa MPa GPa psi ksi, kg g t lb, s ms Hz, deg rad, K degC degF");
    CHECK(refusal("5 kN m", dimension::moment) ==
          "here: \"5 kN m\": cannot read the unit at \"m\"; join units with * / and ^, like kN*m/rad or cm^4");
    CHECK(refusal("5 kN/", dimension::force).find("cannot read the unit at \"\"") != std::string::npos);
    CHECK(refusal("5 m^99", dimension::length).find("cannot read the unit at \"99\"") != std::string::npos);
    CHECK(
        refusal("1e999 kN", dimension::force) ==
        "here: \"1e999 kN\" is beyond the range of numbers; write one that is nearer to 1, or 0 where nothing is meant");
    CHECK(
        refusal("1e308 km", dimension::length) ==
        "here: \"1e308 km\" is beyond the range of numbers; write one that is nearer to 1, or 0 where nothing is meant");
}

TEST_CASE("Converting from one set of base units to another rounds once")
{
    CHECK(converted(12.0, dimension::force_per_length, {LengthUnit::ft, ForceUnit::kip}, in_kip) == 1.0);
    CHECK(converted(205e6, dimension::stress, m_kN, {LengthUnit::mm, ForceUnit::N}) == 205000.0);
    CHECK(converted(1.0, dimension::length, {LengthUnit::in, ForceUnit::N}, {LengthUnit::mm, ForceUnit::N}) == 25.4);
}

TEST_CASE("A number is written with the fewest digits that read back")
{
    CHECK(number_text(0.1) == "0.1");
    CHECK(number_text(-25.0) == "-25");
    CHECK(number_text(205000.0) == "205000");
    CHECK(number_text(2.05e8) == "2.05e8");
    CHECK(number_text(8.333e-6) == "8.333e-6");
    CHECK(number_text(-0.0) == "-0.0");
    CHECK(quantity_text(4500.0, dimension::moment_per_angle, m_kN) == "4500 kN*m/rad");
    CHECK(quantity_text(1.2e-5, dimension::expansion, m_kN) == "1.2e-5 1/K");
    CHECK(quantity_text(7.85, dimension::density, m_kN) == "7.85 kN*s^2/m^4");
}
