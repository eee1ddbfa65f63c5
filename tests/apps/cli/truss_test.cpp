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
    check_refused({"truss", king_post, "--method", "springs"}, "wanted one of joints, sections, cremona");
    check_refused({"render", king_post, "-o", "x.svg", "--cremona", "--stage", "9"}, "--stage");
    check_refused({"render", king_post, "-o", "x.svg", "--stage", "1"}, "--stage needs --cremona too");
    check_refused({"render", "examples/portal.json", "-o", "x.svg", "--cremona"}, "--cremona: ");
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

TEST_CASE("The sheet speaks Portuguese, with a decimal comma")
{
    const Run run = cremona({"truss", king_post, "--lang", "pt"});
    CHECK(run.status == 0);
    CHECK(has(run.out, "1. Nó A: AD e AC são incógnitas."));
    CHECK(has(run.out, "N(AD) = -36,0555 (compressão)"));
}

TEST_SUITE_END();
