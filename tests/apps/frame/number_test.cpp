#include <doctest/doctest.h>

#include <set>
#include <stdexcept>

#include "apps/frame/document/document.h"
#include "apps/frame/document/number.h"
#include "femoop/io/model_file.h"
#include "ui/text/catalogue.h"

namespace {

// A model that has every kind of part, with every kind of load.
constexpr const char* everything = R"({
  "cremona": 1, "analysis": "frame2d", "units": {"length": "m", "force": "kN"},
  "materials": [{"id": "steel", "E": "205 GPa", "nu": 0.3, "alpha": "1.2e-5 1/K", "density": "7850 kg/m^3"}],
  "sections": [{"id": "bar", "shape": "rectangle", "b": 0.2, "h": 0.35}, {"id": "col", "A": 0.012, "Iz": 2.0e-4}],
  "nodes": [{"id": "A", "at": [0, 0.5], "support": {"fixed": ["uy"], "angle": 30, "springs": {"rz": 4500}}},
            {"id": "B", "at": [2.5, 4], "hinge": true}, {"id": "C", "at": [6.5, 4], "support": "fixed"}],
  "members": [{"id": "AB", "nodes": ["A", "B"], "material": "steel", "section": "bar",
               "start": {"spring": {"rz": 700}, "offset": [0.1, 0.2]}, "foundation": {"y": 5000}},
              {"id": "BC", "nodes": ["B", "C"], "material": "steel", "section": "col"}],
  "load_cases": [{"id": "G", "self_weight": 1.1,
     "nodes": [{"node": "B", "fx": 10, "mz": 7}], "settlements": [{"node": "C", "uy": -0.01}],
     "members": [{"member": "AB", "kind": "distributed", "qy": [-10, -25], "from": 0.5, "to": "75%"},
                 {"member": "BC", "kind": "point", "at": "50%", "fy": -40},
                 {"member": "BC", "kind": "ends", "start_mz": 5, "end_mz": -6},
                 {"member": "AB", "kind": "temperature", "top": 10, "bottom": 30},
                 {"member": "BC", "kind": "misfit", "elongation": "2 mm"}]}],
  "combinations": [{"id": "ULS", "factors": {"G": 1.35}}]
})";

frame::Document full_document() { return {femoop::read_model(everything)}; }

} // namespace

TEST_SUITE("frame document")
{
    TEST_CASE("A settlement has a number for each direction that the support holds; the last one given stays")
    {
        frame::Document document = full_document();
        const frame::SettlementPlace place{0, 0};
        const std::vector<frame::Number> all = frame::numbers(document.model, place); // ux uy rz of the fixed node C
        REQUIRE(all.size() == 3);
        CHECK(!all[0].value);
        frame::set_number(document, all[0].id, femoop::Quantity(0.004));
        frame::clear_number(document, all[1].id);
        frame::clear_number(document, all[0].id);
        const auto& components = document.model.load_cases[0].settlements[0].components;
        REQUIRE(components.size() == 1);
        CHECK(components[0].dof == femoop::Dof::ux);
        CHECK(components[0].value == 0.004);
    }

    TEST_CASE("Every number of every part can be set alone: it reads back, and all others stay")
    {
        const frame::Document document = full_document();
        int n_numbers = 0;
        for (const frame::Part& part : frame::parts(document.model)) {
            for (const frame::Number& number : frame::numbers(document.model, part)) {
                CAPTURE(ui::Catalogue()(frame::title(document.model, part)));
                CAPTURE(ui::Catalogue()(number.label));
                frame::Document changed = document;
                const double wanted = number.value.value_or(femoop::Quantity(3.25)).value() + 0.125;
                frame::set_number(changed, number.id, femoop::Quantity(wanted));
                CHECK(changed != document);
                CHECK(frame::numbers(changed.model, part).at(number.id.place).value->value() == wanted);
                if (number.value) frame::set_number(changed, number.id, *number.value);
                if (!number.value) frame::clear_number(changed, number.id);
                CHECK(changed == document);
                ++n_numbers;
            }
        }
        CHECK(n_numbers == 56); // counted by hand in the file above
    }

    TEST_CASE("The numbers of a trapezoidal load are its two values and its two ends")
    {
        const frame::Document document = full_document();
        const auto numbers = frame::numbers(document.model, frame::MemberLoadPlace{0, 0});
        REQUIRE(numbers.size() == 4);
        const ui::Catalogue tr;
        CHECK(tr(numbers[0].label) == "qy, start");
        CHECK(numbers[0].value->value() == -10.0);
        CHECK(tr(numbers[1].label) == "qy, end");
        CHECK(tr(numbers[2].label) == "From");
        CHECK(tr(numbers[3].label) == "To [%]");
        CHECK(numbers[3].value->value() == 75.0);
    }

    TEST_CASE("A number or a part that is not there is refused and nothing changes")
    {
        frame::Document document = full_document();
        const frame::Document before = document;
        CHECK_THROWS_AS(frame::set_number(document, {femoop::NodeId(9), 0}, 1.0), std::out_of_range);
        CHECK_THROWS_AS(frame::set_number(document, {femoop::NodeId(1), 7}, 1.0), std::out_of_range);
        CHECK_THROWS_AS(frame::set_number(document, {frame::MemberLoadPlace{0, 5}, 0}, 1.0), std::out_of_range);
        CHECK_THROWS_AS(frame::clear_number(document, {femoop::NodeId(1), 0}), std::invalid_argument);
        CHECK(document == before);
    }

    TEST_CASE("What is typed without a unit counts in the unit shown, and is saved as it was typed")
    {
        const femoop::Units n_mm{femoop::LengthUnit::mm, femoop::ForceUnit::N};
        const ui::DisplayUnits kn_m(ui::UnitSystem::KnM, frame::base_units(n_mm), {});
        const auto typed = [&](const char* text, ui::Measure measure) {
            return std::get<femoop::Quantity>(frame::quantity_typed(text, measure, n_mm, kn_m));
        };
        CHECK(typed("25", ui::Measure::Force) == femoop::Quantity(25000.0, "25 kN"));
        CHECK(typed("12,5", ui::Measure::Moment) == femoop::Quantity(12.5e6, "12.5 kN*m"));
        CHECK(typed("1140", ui::Measure::SecondMoment) == femoop::Quantity(1.14e7, "1140 cm^4"));
        CHECK(typed("3 kip", ui::Measure::Force).text() == "3 kip");
        CHECK(typed("25", ui::Measure::ForcePerLength) == femoop::Quantity(25.0)); // kN/m is N/mm: nothing to convert
        CHECK(typed("0,3", ui::Measure::Plain) == femoop::Quantity(0.3));
        CHECK(typed("30", ui::Measure::Angle) == femoop::Quantity(30.0));
        CHECK(typed("2*12,5", ui::Measure::Force) == femoop::Quantity(25000.0, "25 kN"));
        CHECK(typed("5*3^2/8 kN*m", ui::Measure::Moment) == femoop::Quantity(5.625e6, "5.625 kN*m"));
        CHECK(typed("12.5 kN·m", ui::Measure::Moment) == femoop::Quantity(12.5e6, "12.5 kN*m"));
        CHECK(typed("1140 cm⁴", ui::Measure::SecondMoment) == femoop::Quantity(1.14e7, "1140 cm^4"));
        CHECK(typed("1/3", ui::Measure::Plain) == femoop::Quantity(1.0 / 3.0));
        CHECK(typed("1,3 m + 100 mm", ui::Measure::Length) == femoop::Quantity(1400.0));
        CHECK(typed("2*(0.5+0.1) m - 250 mm-0.05", ui::Measure::Length) == femoop::Quantity(900.0)); // the last in m
        CHECK(typed("1e-3 m + -2e+1 mm", ui::Measure::Length) == femoop::Quantity(-19.0));
    }

    TEST_CASE("What is no quantity, or one of the wrong dimension, is refused with a reason")
    {
        const femoop::Units units;
        const ui::DisplayUnits shown;
        for (const char* text :
             {"", "abc", "25 kN/m", "1e999", "5 furlong", "1,2,3", "3 kN - 2 m", "3 kN +", "3 kN + (2 kN"}) {
            CAPTURE(text);
            const auto typed = frame::quantity_typed(text, ui::Measure::Force, units, shown);
            REQUIRE(std::holds_alternative<femoop::Fault>(typed));
            CHECK_FALSE(femoop::message(std::get<femoop::Fault>(typed)).empty());
        }
    }

    TEST_CASE("Every label and title of every part is translated")
    {
        const frame::Document document = full_document();
        const ui::Catalogue tr(ui::Language::Portuguese);
        std::set<std::string> same;
        for (const frame::Part& part : frame::parts(document.model)) {
            CHECK(tr.has(frame::title(document.model, part).sentence));
            for (const frame::Number& number : frame::numbers(document.model, part)) {
                if (!tr.has(number.label.sentence)) same.insert(ui::Catalogue()(number.label));
            }
        }
        CHECK(same ==
              std::set<std::string>{"A", "Iy", "Iz", "J", "b", "fx", "fy", "h", "mz", "rz", "ux", "uy", "x", "y"});
    }
}
