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

    TEST_CASE("What a unit load does is counted over the load's unit: a moment under a force is a length")
    {
        const auto kn_m = units(ui::UnitSystem::KnM, n_mm);
        const auto under_force = kn_m.per(ui::Measure::Force), under_moment = kn_m.per(ui::Measure::Moment);
        CHECK(under_force.text(2500.0, ui::Measure::Moment) == "2.5 m"); // 2500 N mm a N
        CHECK(under_force.text(0.7, ui::Measure::Force) == "0.7");
        CHECK(under_moment.text(0.7, ui::Measure::Moment) == "0.7");
        CHECK(under_moment.text(2.0e-3, ui::Measure::Force) == "2 1/m");
        CHECK(under_force.text(4500.0, ui::Measure::Length) == "4.5 m"); // no result
        ui::UnitChoices choices;
        CHECK(choices.choose("moment", "kN·cm"));
        const ui::DisplayUnits chosen(ui::UnitSystem::KnM, n_mm, {.digits = 6}, choices);
        CHECK(chosen.per(ui::Measure::Force).text(2500.0, ui::Measure::Moment) == "250 kN·cm/kN");
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

    TEST_CASE("A unit is chosen for one quantity, and the others keep theirs")
    {
        ui::UnitChoices choices;
        CHECK(choices.choose("moment", "tf*m"));
        CHECK(choices.choose("rotation", "mrad"));
        const ui::DisplayUnits shown(ui::UnitSystem::KnM, {}, {.digits = 6}, choices);
        CHECK(shown.text(9.80665, ui::Measure::Moment) == "1 tf·m");
        CHECK(shown.text(0.002, ui::Measure::Rotation) == "2 mrad");
        CHECK(shown.text(9.80665, ui::Measure::Force) == "9.80665 kN");
        CHECK(shown.stored(1.0, ui::Measure::Moment) == doctest::Approx(9.80665));
    }

    TEST_CASE("Chosen units that do not follow from force and length are told with them")
    {
        ui::UnitChoices choices;
        const auto summary = [&] { return ui::DisplayUnits(ui::UnitSystem::KnM, {}, {}, choices).summary(); };
        CHECK(summary() == "kN, m");
        choices.choose("moment", "kN·cm");
        CHECK(summary() == "kN, m, kN·cm");
        choices.choose("length", "cm");
        choices.choose("line_load", "kN/m");
        CHECK(summary() == "kN, cm, kN/m");
    }

    TEST_CASE("Every unit that can be chosen gives back what was stored, and is read again from its text")
    {
        for (const ui::QuantityUnits& quantity : ui::chosen_quantities()) {
            CAPTURE(quantity.code);
            for (const std::string_view name : quantity.names) {
                CAPTURE(name);
                ui::UnitChoices choices;
                REQUIRE(choices.choose(quantity.code, name));
                const ui::DisplayUnits shown(ui::UnitSystem::File, n_mm, {}, choices);
                CHECK(shown.unit(quantity.measure).name == name);
                CHECK(shown.stored(shown.shown(7.25, quantity.measure), quantity.measure) == doctest::Approx(7.25));
                CHECK(choices.text() == std::string(quantity.code) + "=" + std::string(name));
            }
            ui::UnitChoices choices;
            CHECK_FALSE(choices.choose(quantity.code, "furlong"));
            CHECK(choices.choose(quantity.code, ""));
            CHECK(choices == ui::UnitChoices());
        }
        CHECK_FALSE(ui::UnitChoices().choose("time", "s"));
    }

    TEST_CASE("One pound per square inch is 6894.757 Pa, one kip foot 1.3558179 kN m, one tf/m2 9.80665 kPa")
    {
        const auto factor = [](std::string_view quantity, std::string_view unit, ui::Measure measure) {
            ui::UnitChoices choices;
            choices.choose(quantity, unit);
            return 1.0 / ui::DisplayUnits(ui::UnitSystem::File, {}, {}, choices).unit(measure).factor; // in kN and m
        };
        CHECK(factor("stress", "psi", ui::Measure::Stress) == doctest::Approx(6.894757).epsilon(1e-6));
        CHECK(factor("moment", "kip·ft", ui::Measure::Moment) == doctest::Approx(1.3558179).epsilon(1e-7));
        CHECK(factor("stress", "tf/m²", ui::Measure::Stress) == doctest::Approx(9.80665));
        CHECK(factor("line_load", "lbf/ft", ui::Measure::ForcePerLength) == doctest::Approx(0.01459390).epsilon(1e-6));
        CHECK(factor("inertia", "in⁴", ui::Measure::SecondMoment) == doctest::Approx(41.62314256e-8).epsilon(1e-9));
    }
}
