#include <doctest/doctest.h>

#include <string>
#include <utility>

#include "femoop/io/model_file.h"
#include "femoop/io/train/train_block.h"
#include "femoop/model/fault/fault.h"
#include "femoop/model/quantity/in_units.h"
#include "tests/femoop/io/bad_files.h"

using namespace femoop;
using doctest::Approx;

TEST_SUITE_BEGIN("femoop io");

namespace {

/// A span of 6 m with this train on it.
std::string with_train(const std::string& keys)
{
    return File{.more = R"(, "load_cases": [{"id": "G"}], "trains": [{"id": "T", "path": ["AB"], )" + keys + "}]"}
        .text();
}

std::string train_faults(const std::string& file)
{
    std::string text;
    for (const Fault& fault : examine_model(file).faults) text += message(fault) + "\n";
    return text;
}

Model model_of(const std::string& file)
{
    const ModelReading reading = examine_model(file);
    REQUIRE(reading.is_sound());
    return reading.model;
}

constexpr const char* whole = R"("axles": ["80 kN", 320], "spacings": [4.3], "spacing_ranges": {"1": ["4 m", 9]},
    "both_directions": true, "impact": 1.33, "uniform": "9.3 kN/m", "uniform_extent": "outside", "gap": 0.8,
    "concentrated": [18, {"moment": 20, "shear": 26}], "load": {"fy": -1, "fx": 0.1}}],
    "moving_envelopes": [{"id": "E", "trains": ["T"], "with": "G", "factor": 1.35)";

} // namespace

TEST_CASE("A train and an envelope are read, and written back as they were typed")
{
    const Model model = model_of(with_train(whole));
    const Train& train = model.moving_loads.trains.at(0);
    CHECK(train.axles.at(0).text() == "80 kN");
    CHECK(train.spacing_ranges.at(0).spacing == 0);
    CHECK(train.spacing_ranges.at(0).max.value() == 9.0);
    CHECK(train.impact == 1.33);
    CHECK(train.uniform_extent == UniformExtent::Outside);
    CHECK(train.concentrated.at(1).for_others.value().value() == 26.0);
    CHECK(model.moving_loads.envelopes.at(0).factor == 1.35);
    CHECK(model_of(write_model(model)) == model);
}

TEST_CASE("In other units a train is the same train")
{
    const Model model = in_units(model_of(with_train(whole)), {LengthUnit::cm, ForceUnit::N});
    const Train& train = model.moving_loads.trains.at(0);
    CHECK(train.axles.at(0).value() == Approx(80e3));
    CHECK(train.spacings.at(0).value() == Approx(430.0));
    CHECK(train.uniform.value().value() == Approx(93.0));
    CHECK(train.impact == 1.33);
    CHECK(train.concentrated.at(0).for_moments.value() == Approx(18e3));
}

TEST_CASE("Where it adds is another word for adverse")
{
    const Model model = model_of(with_train(R"("uniform": 3, "uniform_extent": "where it adds")"));
    CHECK(model.moving_loads.trains.at(0).uniform_extent == UniformExtent::Adverse);
}

TEST_CASE("A train that cannot move is refused, with what is wanted")
{
    const std::string place = "trains[0] \"T\"";
    const std::pair<const char*, std::string> bad[]{
        {R"("axles": [])", place + ": has neither axles nor a uniform load; give one of them"},
        {R"("axles": [1, 2, 3], "spacings": [4])",
         place + ": number of axles 3, of spacings 1, wanted 2; give one spacing behind each axle but the last"},
        {R"("axles": [1, 2, 3], "spacings": [4], "spacing_ranges": {"2": [3, 5]})",
         place + ": number of axles 3, of spacings 1, wanted 2; give one spacing behind each axle but the last"},
        {R"("axles": [1, 2], "spacings": [-4])", place + ": spacing 1 is -4 m; give 0 or a positive value"},
        {R"("axles": [1], "uniform": 3, "gap": -0.5)", place + ": gap is -0.5 m; give 0 or a positive value"},
        {R"("axles": [1, 2], "spacings": [4], "spacing_ranges": {"2": [3, 5]})",
         place +
             ": there is no spacing \"2\" that could have a range; count from 1, behind the leading axle: there are 1"},
        {R"("axles": [1, 2], "spacings": [4], "spacing_ranges": {"x": [3, 5]})",
         "trains[0].spacing_ranges: there is no spacing \"x\" that could have a range; "
         "count from 1, behind the leading axle: there are 1"},
        {R"("axles": [1, 2], "spacings": [4], "spacing_ranges": {"1": [5, 3]})",
         "trains[0].spacing_ranges.1: goes from 5 m down to 3 m; give the smaller value first"},
        {R"("axles": [1, 2], "spacings": [4], "spacing_ranges": {"1": [5]})",
         "trains[0].spacing_ranges.1: found a list of 1, wanted 2 lengths; give the least and the most"},
        {R"("axles": [1], "load": {"fy": 0})",
         place + ": the unit load has no direction; give a component that is not 0, or leave the load out: it is down"},
    };
    for (const auto& each : bad) {
        CAPTURE(each.first);
        CHECK(train_faults(with_train(each.first)) == each.second + "\n");
    }
    CHECK(train_faults(with_train(R"("axles": [1], "uniform_extent": "everywherex")")).find("everywhere") !=
          std::string::npos);
}

TEST_CASE("An envelope names trains that are there")
{
    CHECK(train_faults(with_train(R"("axles": [1]}], "moving_envelopes": [{"id": "E", "trains": ["U"])")) ==
          "moving_envelopes[0].trains[0]: no train \"U\"; add it to trains or name another\n");
    CHECK(train_faults(with_train(R"("axles": [1]}], "moving_envelopes": [{"id": "E", "trains": [])")) ==
          "moving_envelopes[0] \"E\": names no train; name one or more\n");
}

TEST_CASE("A block is a train with its answers")
{
    const Model model = model_of(File{.more = R"(, "train": {"name": "truck", "path": ["AB"], "axles": [8, 32],
        "spacings": [14], "expected": [{"quantity": "extreme", "member": "AB", "component": "M", "which": "max",
        "value": 5, "position": [2, 4]}]})"}
                                     .text());
    const auto block = influence::train_block_of(model);
    REQUIRE(block);
    CHECK(block->train.id == "truck");
    CHECK(block->checks.at(0).which == ExtremeKind::Max);
    CHECK(block->checks.at(0).sections.size() == 2);
    const Model bad = model_of(File{.more = R"(, "train": {"path": ["AB"], "axles": [8], "spacing": [14]})"}.text());
    CHECK_THROWS_WITH_AS(static_cast<void>(influence::train_block_of(bad)),
                         "train.spacing: unknown key; did you mean \"spacings\"?", ModelError);
}

TEST_SUITE_END();
