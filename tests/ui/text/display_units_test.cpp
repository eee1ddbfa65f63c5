#include <doctest/doctest.h>

#include "ui/text/display_units.h"

namespace {

const ui::BaseUnits n_mm{.length = "mm", .metres = 1.0e-3, .force = "N", .newtons = 1.0};

ui::DisplayUnits units(ui::UnitSystem system, const ui::BaseUnits& base) { return {system, base, {.digits = 6}}; }

} // namespace

TEST_SUITE("ui text")
{
    TEST_CASE("A file in N and mm is shown in kN and m: 25 N/mm are 25 kN/m, 3e6 N mm are 3 kN m")
    {
        const auto kn_m = units(ui::UnitSystem::KnM, n_mm);
        CHECK(kn_m.text(25.0, ui::Measure::ForcePerLength) == "25 kN/m");
        CHECK(kn_m.text(3.0e6, ui::Measure::Moment) == "3 kN·m");
        CHECK(kn_m.text(205000.0, ui::Measure::Stress) == "205000 MPa");
        CHECK(kn_m.text(1.14e7, ui::Measure::SecondMoment) == "1140 cm⁴");
        CHECK(kn_m.text(2.5, ui::Measure::Displacement) == "2.5 mm");
        CHECK(kn_m.text(7.85e-9, ui::Measure::Density) == "7850 kg/m³");
    }

    TEST_CASE("The file's own units leave every number as it is stored")
    {
        const auto file = units(ui::UnitSystem::File, n_mm);
        for (const auto measure : {ui::Measure::Length, ui::Measure::Moment, ui::Measure::Stress, ui::Measure::Area,
                                   ui::Measure::SecondMoment, ui::Measure::Displacement}) {
            CAPTURE(static_cast<int>(measure));
            CHECK(file.shown(12.5, measure) == doctest::Approx(12.5));
        }
        CHECK(file.unit(ui::Measure::SecondMoment).name == "mm⁴");
    }

    TEST_CASE("In US units 1 kip is 4448.2216 N, 1 ft is 0.3048 m and E of steel is 29733 ksi")
    {
        const auto us = units(ui::UnitSystem::Us, {});
        CHECK(us.shown(4.4482216152605, ui::Measure::Force) == doctest::Approx(1.0));
        CHECK(us.shown(0.3048, ui::Measure::Length) == doctest::Approx(1.0));
        CHECK(us.text(205.0e6, ui::Measure::Stress) == "29732.7 ksi"); // 205 GPa / 6.894757 MPa
    }

    TEST_CASE("What is shown and stored again is what it was, in every system and for every measure")
    {
        for (const ui::UnitSystem system : ui::all_unit_systems) {
            for (int m = 0; m <= static_cast<int>(ui::Measure::Expansion); ++m) {
                CAPTURE(m);
                const auto shown = units(system, n_mm);
                const auto measure = static_cast<ui::Measure>(m);
                CHECK(shown.stored(shown.shown(7.25, measure), measure) == doctest::Approx(7.25));
            }
        }
    }

    TEST_CASE("A label carries its unit")
    {
        CHECK(units(ui::UnitSystem::Si, n_mm).label("Length", ui::Measure::Length) == "Length [m]");
        CHECK(units(ui::UnitSystem::Si, n_mm).label("Factor", ui::Measure::Plain) == "Factor");
    }

    TEST_CASE("Each unit system is found by its code")
    {
        for (const ui::UnitSystem system : ui::all_unit_systems)
            CHECK(ui::unit_system_named(ui::code(system)) == system);
        CHECK_FALSE(ui::unit_system_named("metric"));
    }
}
