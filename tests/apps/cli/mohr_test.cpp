#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/apps/cli/run_cremona.h"

using cli_test::cremona;
using cli_test::has;
using cli_test::Run;
using doctest::Approx;
using nlohmann::json;

TEST_SUITE_BEGIN("cremona");

namespace {

json results(std::vector<std::string> arguments)
{
    arguments.insert(arguments.begin(), "mohr");
    arguments.emplace_back("--json");
    const Run run = cremona(arguments);
    CHECK(run.err.empty());
    return json::parse(run.out);
}

std::string refusal(std::vector<std::string> arguments)
{
    arguments.insert(arguments.begin(), "mohr");
    const Run run = cremona(arguments);
    CHECK(run.status == 2);
    CHECK(run.out.empty());
    return run.err;
}

std::string a_case(const std::string& expected)
{
    return R"([{"id": "A", "input": {"stress": [-20, 90, 60]}, "expected": {)" + expected + "}}]";
}

} // namespace

TEST_CASE("Mohr's circle of a plane stress has its pole at sx and txy and face x turned")
{
    const json r = results({"--stress", "-20,90,60", "--angle", "90"});
    CHECK(r["pole"] == json({-20, 60}));
    CHECK(r["rotated"] == json({90, -20, -60}));
    CHECK(r["theta_p_deg"].get<double>() == Approx(66.25522354));
}

TEST_CASE("A direction that does not exist is null in JSON and told in words in the table")
{
    CHECK(results({"--stress", "5,5,0"})["theta_p_deg"].is_null());
    CHECK(has(cremona({"mohr", "--stress", "5,5,0"}).out, "none: every direction is"));
}

TEST_CASE("A criterion adds the safety factor and the planes that fail")
{
    const json tresca = results({"--stress", "50,-10,40", "--criterion", "tresca", "--strength", "fy=250"});
    CHECK(tresca["safety_factor"].get<double>() == Approx(250.0 / 100.0));
    CHECK(tresca["failing_planes"].size() == 2);
    const json ksi = results({"--stress", "1 ksi,0,0", "--criterion", "von_mises", "--strength", "fy=2000 psi"});
    CHECK(ksi["safety_factor"].get<double>() == Approx(2.0));
    const json strain = results({"--strain", "1000e-6,0,0", "--E", "200 GPa", "--nu", "0", "--criterion", "rankine",
                                 "--strength", "ft=100 MPa,fc=1 GPa"});
    CHECK(strain["safety_factor"].get<double>() == Approx(0.5));
    const std::vector<std::string> pressure{"--stress",     "-5,-5,-5,0,0,0", "--criterion",
                                            "mohr_coulomb", "--strength",     "c=10,phi=30"};
    CHECK(results(pressure)["safety_factor"].is_null());
    CHECK(results({"--stress", "50,-10,40"}).contains("safety_factor") == false);
}

TEST_CASE("A criterion that cannot be judged says what it wants")
{
    const auto with = [](std::vector<std::string> more) {
        more.insert(more.begin(), {"--stress", "50,-10,40"});
        return refusal(more);
    };
    CHECK(has(with({"--criterion", "mises"}), "--criterion: found \"mises\"; wanted one of tresca, von_mises"));
    CHECK(has(with({"--criterion", "tresca"}), "--strength: tresca wants fy=..."));
    CHECK(has(with({"--criterion", "tresca", "--strength", "ft=3"}), "--strength: tresca wants fy=..."));
    CHECK(has(with({"--criterion", "tresca", "--strength", "fy=-3"}),
              "--strength fy: found -3; wanted a number greater"));
    CHECK(has(with({"--criterion", "mohr_coulomb", "--strength", "c=3,phi=90"}), "--strength phi: found 90; wanted"));
    CHECK(has(with({"--criterion", "tresca", "--strength", "fy=nan"}), "--strength fy"));
    CHECK(has(with({"--strength", "fy=3"}), "--strength: wanted with --criterion alone"));
    CHECK(has(refusal({"--inertia", "1,2,0", "--criterion", "tresca", "--strength", "fy=1"}), "do not fail"));
    CHECK(has(refusal({"--strain", "1,2,0", "--criterion", "tresca", "--strength", "fy=1"}), "give --E and --nu"));
}

TEST_CASE("Second moments that no section has are worked, and it is said")
{
    const std::string note = "no section has these second moments";
    CHECK(has(cremona({"mohr", "--inertia", "1,1,5"}).out, note));
    CHECK(!has(cremona({"mohr", "--inertia", "2900,5600,-3000"}).out, note));
    CHECK(results({"--inertia", "1,1,5"})["possible"] == false);
    CHECK(!results({"--inertia", "2900,5600,-3000"}).contains("possible"));
}

TEST_CASE("Stresses typed in several units come out in the first one")
{
    const json r = results({"--stress", "1 ksi,0,1000 psi"});
    CHECK(r["unit"] == "ksi");
    CHECK(r["radius"].get<double>() == Approx(std::sqrt(1.25)));
}

TEST_CASE("The plane of a normal is reported whatever the normal's length")
{
    const json a = results({"--stress", "3,3,3,2,2,2", "--normal", "1,1,1"});
    const json b = results({"--stress", "3,3,3,2,2,2", "--normal", "1e-9,1e-9,1e-9"});
    CHECK(a["sigma_n"].get<double>() == Approx(7.0));
    CHECK(b["sigma_n"].get<double>() == Approx(7.0));
}

TEST_CASE("A case that comes out otherwise fails with status 1 and one that cannot be compared is skipped by name")
{
    const Run wrong = cremona({"mohr", "--cases", "-"}, a_case(R"("center": 35.1, "radius": 81.394103)"));
    CHECK(wrong.status == 1);
    CHECK(has(wrong.out, "A: center = 35, expected 35.1 within 3.51e-05: FAILED\n"));
    CHECK(has(wrong.out, "1 passed, 1 failed, 0 skipped\n"));
    const Run unknown = cremona({"mohr", "--cases", "-"}, a_case(R"("centre": 35)"));
    CHECK(unknown.status == 0);
    CHECK(has(unknown.out, "A: centre: skipped: there is no such result of this input\n"));
    const Run null = cremona({"mohr", "--cases", "-"}, a_case(R"("theta_p_deg": null)"));
    CHECK(null.status == 1);
}

TEST_CASE("A file of cases that cannot be read is refused with the place")
{
    const auto message = [](const std::string& file) {
        const Run run = cremona({"mohr", "--cases", "-"}, file);
        CHECK(run.status == 2);
        CHECK(run.out.empty());
        return run.err;
    };
    CHECK(has(message("[{"), "standard input: error: "));
    CHECK(has(message("{}"), "standard input: wanted a list of cases"));
    CHECK(has(message("\n"), "standard input: wanted a list of cases"));
    CHECK(has(message(R"([{"id": "A"}])"), R"(A: wanted an object with "input" and "expected")"));
    CHECK(has(message(R"([{"id": "A", "input": {"stress": [1, "x", 2]}, "expected": {}}])"), "A: --stress SY: \"x\""));
    CHECK(has(message(R"([{"input": {"stress": "1"}, "expected": {}}])"), "[0].stress: found \"1\"; wanted a list"));
}

TEST_CASE("What Mohr's circle cannot be drawn of is refused with a remedy")
{
    CHECK(has(refusal({"--json"}), "no state is given; give one of --stress, --strain, --rosette, --inertia"));
    CHECK(has(refusal({"--stress", "1,2"}), "wanted SX,SY,TXY or SX,SY,SZ,TXY,TYZ,TZX, separated by commas"));
    CHECK(has(refusal({"--stress", "1,2,inf"}), "--stress TXY: \"inf\" does not begin with a number"));
    CHECK(has(refusal({"--stress", "1 kN,2 kN,0"}), "\"1 kN\" measures force, wanted stress"));
    CHECK(has(refusal({"--stress", "1,2,3", "--inertia", "1,2,3"}), "more than one state"));
    CHECK(has(refusal({"--stress", "1,2,3", "--normal", "0,0,0"}), "0,0,0 has no direction"));
    CHECK(has(refusal({"--strain", "1,2,3", "--nu", "0.7"}), "found 0.7; wanted a number greater than -1"));
    CHECK(has(refusal({"--strain", "1,2,3", "--E", "200"}), "give --nu"));
    CHECK(has(refusal({"--strain", "1,2,3", "--E", "-200", "--nu", "0.3"}), "wanted a number greater than 0"));
    CHECK(has(refusal({"--stress", "1,2,3", "--E", "200"}), "take them away"));
    CHECK(has(refusal({"--rosette", "0,180,90:1,2,3"}), "gauges 1 and 2 measure along one direction"));
    CHECK(has(refusal({"--rosette", "0,45,90"}), "wanted A1,A2,A3:R1,R2,R3"));
    CHECK(has(refusal({"--stress", "1,2,3", "--plane-strain"}), "give --nu"));
    CHECK(has(refusal({"--stress", "1,2,3,4,5,6", "--angle", "3"}), "give --normal"));
    CHECK(has(refusal({"--inertia", "1,2,3", "--normal", "1,0,0"}), "no third direction"));
}

TEST_CASE("Mohr's circle speaks Portuguese with a decimal comma")
{
    const Run run = cremona({"mohr", "--stress", "-20,90,60", "--lang", "pt"});
    CHECK(has(run.out, "raio do círculo"));
    CHECK(has(run.out, "81,3941"));
}

TEST_SUITE_END();
