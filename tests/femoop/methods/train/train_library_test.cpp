// Trains of the standards: what they weigh and how long they are, as published, in any units.
#include "femoop/methods/influence/train/train_library.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string_view>
#include <vector>

#include "femoop/io/model_file.h"
#include "femoop/methods/influence/train/train_analysis.h"
#include "femoop/model/check/check.h"
#include "tests/frame_maker.h"

using namespace femoop;
using namespace femoop::influence;
using doctest::Approx;

TEST_SUITE_BEGIN("femoop train");

namespace {

const LibraryTrain& entry(std::string_view name)
{
    const auto all = train_library();
    const auto found = std::ranges::find(all, name, &LibraryTrain::name);
    REQUIRE(found != all.end());
    return *found;
}

double weight(const LibraryTrain& train) { return std::accumulate(train.axles.begin(), train.axles.end(), 0.0); }
double length(const LibraryTrain& train) { return std::accumulate(train.spacings.begin(), train.spacings.end(), 0.0); }

/// The largest bending moment of a simple span, anywhere in it.
double largest_moment(std::string_view name, double span, const Units& units)
{
    FrameMaker made;
    made.model.units = units;
    made.node("A", 0, 0, SupportKind::Pin).node("B", span, 0, SupportKind::Roller);
    made.member("A", "B");
    const Train train = train_from(entry(name), units, std::vector{MemberId(0)});
    TrainAnalysis analysis(made.model);
    return analysis
        .extreme(train,
                 {.quantity = ExpectedQuantity::Extreme, .member = MemberId(0), .component = MemberComponent::Mz})
        .max.placing.value;
}

constexpr Units us{.length = LengthUnit::ft, .force = ForceUnit::kip},
    si{.length = LengthUnit::m, .force = ForceUnit::kN};

} // namespace

TEST_CASE("Trains of the library weigh what their standards say, over the lengths that these give")
{
    CHECK(weight(entry("HS20-44 truck")) == 72.0); // [kip]
    CHECK(length(entry("HS20-44 truck")) == 28.0); // [ft]
    CHECK(weight(entry("HL-93 tandem + lane")) == 50.0);
    CHECK(weight(entry("Cooper E80 engines")) == 2.0 * 568.0); // 284 t each, the 80 being a driver's kips
    CHECK(length(entry("Cooper E80 engines")) == 104.0);
    CHECK(weight(entry("LM1 lane 1")) == 600.0); // [kN]
    CHECK(weight(entry("LM71")) == 1000.0);
    CHECK(length(entry("LM71")) == Approx(4.8)); // and 0.8 m more at either end: the 6.4 m of the figure
    CHECK(weight(entry("TB-450")) == 450.0);
    CHECK(length(entry("TB-450")) + 2.0 * entry("TB-450").gap == 6.0); // as long as the ground that it takes
}

TEST_CASE("An engine of Cooper's is the same twice, axle by axle")
{
    const LibraryTrain& train = entry("Cooper E80 engines");
    REQUIRE(train.axles.size() == 18);
    REQUIRE(train.spacings.size() == 17);
    for (std::size_t i = 0; i < 9; ++i) CHECK(train.axles[i] == train.axles[i + 9]);
    for (std::size_t i = 0; i < 8; ++i) CHECK(train.spacings[i] == train.spacings[i + 9]);
}

TEST_CASE("Cooper's engines have no cars behind them, as no extent lies on one side alone, and say so")
{
    const LibraryTrain& train = entry("Cooper E80 engines");
    CHECK(train.uniform == 0.0);
    CHECK(train.left_out.find("8 kip/ft of the cars, which begin 5 ft behind the last axle") != std::string_view::npos);
}

TEST_CASE("Trains of the library do on simple spans what the tables of their standards say")
{
    // AASHTO 2002, appendix A: moments of HS20-44 on 40 ft and 100 ft by the truck, on 200 ft by the lane [kip ft].
    CHECK(largest_moment("HS20-44 truck", 40.0, us) == Approx(449.8).epsilon(2e-4));
    CHECK(largest_moment("HS20-44 truck", 100.0, us) == Approx(1524.0).epsilon(2e-4));
    CHECK(largest_moment("HS20-44 lane", 200.0, us) == Approx(4100.0));
    // By hand: two axles about the middle, P (L - c / 2)^2 / 2 L, and q L^2 / 8 is not at the same section.
    CHECK(largest_moment("LM1 lane 1", 20.0, si) > 300.0 * 19.4 * 19.4 / 40.0 + 27.0 * 50.0 * 0.99);
}

TEST_CASE("A train of the library is the same in every unit that a model counts in")
{
    for (const LibraryTrain& one : train_library()) {
        CAPTURE(one.name);
        const double here = largest_moment(one.name, 30.0, us);
        const double there = largest_moment(one.name, 30.0 * 0.3048, si);
        CHECK(there == Approx(here * 0.3048 * 4.4482216152605).epsilon(1e-9));
    }
}

TEST_CASE(
    "A train of the library keeps the standard's numbers in a model of other units, and needs no words in its own")
{
    const Train metric = train_from(entry("HS20-44 truck"), si, std::vector{MemberId(0)});
    CHECK(metric.axles[1].text() == "32 kip");
    CHECK(metric.axles[1].value() == 32.0 * 4.4482216152605);
    CHECK(metric.spacing_ranges[0].max.text() == "30 ft");
    CHECK(metric.spacing_ranges[0].max.value() == 30.0 * 0.3048);
    CHECK(train_from(entry("HL-93 truck + lane"), si, std::vector{MemberId(0)}).uniform->text() == "0.64 kip/ft");
    CHECK(!train_from(entry("HS20-44 truck"), us, std::vector{MemberId(0)}).axles[1].has_text());
}

TEST_CASE("Every train of the library is one that a file may have")
{
    for (const LibraryTrain& one : train_library()) {
        CAPTURE(one.name);
        FrameMaker made;
        made.node("A", 0, 0, SupportKind::Pin).node("B", 30, 0, SupportKind::Roller);
        made.member("A", "B");
        made.model.moving_loads.trains = {train_from(one, made.model.units, std::vector{MemberId(0)})};
        CHECK(check(made.model).empty());
        CHECK(read_model(write_model(made.model)).moving_loads == made.model.moving_loads);
        CHECK(!one.source.empty());
    }
}

TEST_CASE("A train is known as that of the library whatever it is called, until a number of it is changed")
{
    for (const LibraryTrain& one : train_library()) {
        CAPTURE(one.name);
        Train train = train_from(one, si, std::vector{MemberId(3)});
        train.id = "heavy";
        const LibraryTrain* const known = library_entry(train, si);
        REQUIRE(known != nullptr);
        CHECK(known->name == one.name);
        CHECK(!known->left_out.empty());
        train.impact *= 1.07;
        CHECK(library_entry(train, si) == nullptr);
    }
}

TEST_SUITE_END();
