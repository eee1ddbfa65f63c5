#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/apps/cli/run_cremona.h"

using cli_test::cremona;
using cli_test::has;
using cli_test::Run;

TEST_SUITE_BEGIN("cremona");

namespace {

constexpr const char* king_post = "examples/truss.json";

void check_refused(const std::vector<std::string>& arguments, const std::string& reason)
{
    const Run run = cremona(arguments);
    CAPTURE(reason);
    CHECK(run.status == 2);
    CHECK(run.out.empty());
    CHECK(has(run.err, reason));
}

} // namespace

TEST_CASE("What is no determinate plane truss is refused with the reason")
{
    check_refused({"truss", "examples/portal.json"}, "are for plane trusses, and this is a frame2d");
    check_refused({"truss", "tests/cases/members/TR-002.json"}, "statically indeterminate to degree 1");
    check_refused({"truss", "tests/cases/members/TR-002.json", "--method", "cremona"}, "statically indeterminate");
    check_refused({"truss", king_post, "--cut", "AC,CD"}, "without AC and CD the truss still hangs together");
    check_refused({"truss", king_post, "--cut", "AC,AC"}, "a section cuts two bars at least");
    check_refused({"truss", king_post, "--cut", "AC,CX"}, "there is no \"CX\"");
    check_refused({"truss", king_post, "--method", "sections"}, "--method sections needs --cut too");
    check_refused({"truss", king_post, "--method", "joints", "--cut", "AC,CD"}, "contradict one another");
    check_refused({"truss", king_post, "--json", "--latex"}, "print different things");
    check_refused({"truss", king_post, "--method", "springs"}, "wanted one of zero-force, joints, sections, cremona");
    check_refused({"render", king_post, "-o", "x.svg", "--cremona", "--stage", "9"}, "--stage");
    check_refused({"render", king_post, "-o", "x.svg", "--stage", "1"}, "--stage needs --truss too");
    check_refused({"render", "examples/portal.json", "-o", "x.svg", "--cremona"}, "--truss: ");
    check_refused({"render", king_post, "-o", "x.svg", "--truss", "springs"},
                  "wanted one of zero-force, joints, cremona");
    check_refused({"render", king_post, "-o", "x.svg", "--cremona", "--truss", "joints"}, "contradict one another");
    check_refused({"truss", "tests/cases/members/TR-002.json", "--method", "zero-force"}, "statically indeterminate");
}

TEST_CASE("A truss that can move is told so, and the status is 3")
{
    const Run run = cremona({"truss", "examples/mechanism.json"});
    CHECK(run.status == 3);
    CHECK(run.out.empty());
}

TEST_CASE("Sides of the diagram as JSON are what solve gives as forces")
{
    const auto truss = nlohmann::json::parse(cremona({"truss", king_post, "--method", "cremona", "--json"}).out);
    const auto& sides = truss["truss"]["sides"];
    REQUIRE(sides.size() == 5);
    CHECK(sides[0]["bar"] == "AC");
    CHECK(sides[0]["N"].get<double>() == doctest::Approx(30.0));
    CHECK(truss["truss"]["closing_error"].get<double>() < 1e-9);
}

TEST_CASE("Zero-force bars stand in the sheet, in the count and in the JSON of both, each with its rule")
{
    const std::string pratt = "examples/pratt_truss.json";
    const std::string rule =
        "L3U3: at joint U3, where no force acts from outside, it stands alone beside two bars in line";
    const Run sheet = cremona({"truss", pratt, "--method", "zero-force"});
    CHECK(sheet.status == 0);
    CHECK(has(sheet.out, rule));
    CHECK(has(sheet.out, "L3U3 carries nothing: 1 of 21 bars."));
    CHECK(!has(sheet.out, "Joint by joint"));
    CHECK(has(cremona({"check", pratt, "--count"}).out, "Load case P: L3U3 carries nothing: 1 of 21 bars.\n  " + rule));
    CHECK(!has(cremona({"check", "examples/portal.json", "--count"}).out, "nothing"));
    const auto truss = nlohmann::json::parse(cremona({"truss", pratt, "--method", "zero-force", "--json"}).out);
    const auto count = nlohmann::json::parse(cremona({"check", pratt, "--count", "--json"}).out);
    for (const auto& bars : {truss["truss"]["zero_force_bars"], count["files"][0]["zero_force_bars"]}) {
        REQUIRE(bars.size() == 1);
        CHECK(bars[0]["bar"] == "L3U3");
        CHECK(bars[0]["rule"] == "third_bar");
        CHECK(bars[0]["joint"] == "U3");
        CHECK(bars[0]["without"].empty());
    }
}

TEST_CASE("The sheet speaks Portuguese, with a decimal comma")
{
    const Run run = cremona({"truss", king_post, "--lang", "pt"});
    CHECK(run.status == 0);
    CHECK(has(run.out, "1. Nó A: AD e AC são incógnitas."));
    CHECK(has(run.out, "N(AD) = −36,0555 (compressão)"));
}

TEST_SUITE_END();
