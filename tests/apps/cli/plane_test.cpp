#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "tests/apps/cli/run_cremona.h"
#include "tests/text_of.h"

using cli_test::has;
using cli_test::Run;
using nlohmann::json;

TEST_SUITE_BEGIN("cremona");

namespace {

const std::string bending = "tests/cases/plane/PB-001-Q8.json";

std::string drawing()
{
    return R"({"cremona": 1, "analysis": "plane_stress", "units": {"length": "m", "force": "N"},
               "curves": [{"id": "c", "kind": "circle", "center": [0, 0], "radius": 2}],
               "expected": [{"quantity": "count", "component": "regions", "value": 1}]})";
}

} // namespace

TEST_CASE("A plane model is solved to the JSON that programs read")
{
    const Run run = cli_test::cremona({"solve", "--json", "--full", "--at", "5,0.5", "--cut", "3.3,-1,3.3,1", bending});
    REQUIRE(run.status == 0);
    const json out = json::parse(run.out);
    CHECK(out["analysis"] == "plane_stress");
    CHECK(out["mesh"]["nodes"] == 45);
    CHECK(out["mesh"]["elements"].size() == 10);
    CHECK(out["mesh"]["min_angle"].get<double>() == doctest::Approx(90.0));
    CHECK(out["regions"]["plate"]["area"].get<double>() == doctest::Approx(20.0));
    const json& M = out["cases"]["M"];
    CHECK(M["points"]["C"]["u"]["ux"].get<double>() == doctest::Approx(-1.5));
    CHECK(M["points"]["C"]["stress"]["plate"]["sx"].get<double>() == doctest::Approx(-150.0));
    CHECK(!M["points"]["C"].contains("reaction"));
    CHECK(M["points"]["E"].contains("reaction"));
    CHECK(M["curves"]["left"]["reaction"]["mz"].get<double>() == doctest::Approx(-100.0));
    CHECK(M["regions"]["plate"]["extremes"]["sx"]["max"]["value"].get<double>() == doctest::Approx(150.0));
    CHECK(M["probes"][0]["stress"]["plate"]["sx"].get<double>() == doctest::Approx(-75.0));
    CHECK(M["cuts"][0]["M"].get<double>() == doctest::Approx(100.0));
    CHECK(M["cuts"][0]["stations"][0]["sx'"].get<double>() == doctest::Approx(150.0));
    CHECK(M["energy"].get<double>() == doctest::Approx(75.0));
    CHECK(M["equilibrium"]["sum_loads"][2].get<double>() == doctest::Approx(100.0));
}

TEST_CASE("A drawing is looked at, its counts are compared, and its mesh is refused by name")
{
    const Run solved = cli_test::cremona({"solve", "-"}, drawing()),
              meshed = cli_test::cremona({"mesh", "-"}, drawing()),
              verified = cli_test::cremona({"verify", "-"}, drawing());
    for (const Run& run : {solved, meshed}) {
        CHECK(run.status == 2);
        CHECK(has(run.err, "is not built yet"));
    }
    CHECK(verified.status == 0);
    CHECK(has(verified.out, "count regions = 1, expected 1 within 1e-06: passed"));
    CHECK(has(verified.out, "1 passed, 0 failed, 0 skipped"));
}

TEST_CASE("mesh --regions prints the faces of a drawing, for people and for programs")
{
    const Run text = cli_test::cremona({"mesh", "--regions", "examples/plate.json"});
    CHECK(text.status == 0);
    CHECK(has(text.out, "8 vertices, 10 edges, 3 regions, 1 components"));
    const json out = json::parse(cli_test::cremona({"mesh", "--regions", "--json", "examples/plate.json"}).out);
    CHECK(out["vertices"] == 8);
    REQUIRE(out["faces"].size() == 3);
    CHECK(out["faces"][0]["region"] == "plate");
    const double hole = std::numbers::pi * 100.0 / 4.0, right = 1250.0; // a quarter of the circle, half of the square
    CHECK(out["faces"][0]["area"].get<double>() + out["faces"][1]["area"].get<double>() ==
          doctest::Approx(2500.0 - hole).epsilon(1e-12));
    CHECK(out["faces"][0]["area"].get<double>() == doctest::Approx(right).epsilon(1e-12));
}

TEST_CASE("mesh wants a drawing")
{
    CHECK(has(cli_test::cremona({"mesh", "examples/portal.json"}).err, "has no regions; give a plane model"));
    CHECK(has(cli_test::cremona({"mesh", bending}).err, "the file has its mesh already"));
}

TEST_CASE("A plane body that can move is refused with status 3 and the region that moves")
{
    std::string text = text_of_source(bending);
    for (const std::string& support :
         {std::string(R"(, "support": "pin")"), std::string(R"(, "support": {"fixed": ["ux"]})")})
        text.replace(text.find(support), support.size(), "");
    const Run run = cli_test::cremona({"solve", "-"}, text);
    CHECK(run.status == 3);
    CHECK(has(run.err, "the part in plate moves along x"));
    CHECK(has(run.err, "the part in plate turns about"));
}

TEST_CASE("A plane model that is converted is tidied, and other commands refuse it by name")
{
    const Run first = cli_test::cremona({"convert", bending, "-"});
    REQUIRE(first.status == 0);
    CHECK(first.out == text_of_source(bending));
    const Run drawn = cli_test::cremona({"render", bending, "-o", "plate.svg"});
    CHECK(drawn.status == 2);
    CHECK(has(drawn.err, "plane_stress is a plane model, for which this is not built yet"));
    CHECK(cli_test::cremona({"convert", bending, "-", "--units", "mm,N"}).status == 2);
    CHECK(cli_test::cremona({"solve", bending, "--trace", "1"}).status == 2);
    CHECK(cli_test::cremona({"solve", bending, "--funicular", "automatic"}).status == 2);
}

TEST_CASE("A place or a cut outside the material is refused, and both belong to plane models")
{
    CHECK(has(cli_test::cremona({"solve", bending, "--at", "50,0"}).err, "no element is at 50,0"));
    CHECK(has(cli_test::cremona({"solve", bending, "--at", "50"}).err, "wanted 2 numbers"));
    CHECK(has(cli_test::cremona({"solve", bending, "--cut", "50,0,60,0"}).err, "meets no material"));
    const Run frame = cli_test::cremona({"solve", "examples/portal.json", "--at", "1,1"});
    CHECK(frame.status == 2);
    CHECK(has(frame.err, "are for plane models"));
}

TEST_SUITE_END();
