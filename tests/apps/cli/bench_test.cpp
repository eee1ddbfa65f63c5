#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/apps/cli/run_cremona.h"

using cli_test::cremona;
using cli_test::has;
using cli_test::Run;

TEST_SUITE_BEGIN("cremona");

TEST_CASE("A frame of 9 by 10 has 300 degrees of freedom and sways 12.604187 mm, whichever solver is asked")
{
    for (const char* solver : {"automatic", "skyline", "ldlt"}) {
        CAPTURE(solver);
        const Run run = cremona({"bench", "frame", "--bays", "9", "--storeys", "10", "--solver", solver, "--json"});
        REQUIRE(run.status == 0);
        const auto report = nlohmann::json::parse(run.out);
        CHECK(report["dofs"] == 300);
        CHECK(report["sway"].get<double>() == doctest::Approx(0.012604187).epsilon(1e-7)); // several programs agree
        for (const char* phase : {"assemble", "order", "factor", "solve", "recover", "total", "peak_mb", "nnz_factor"})
            CHECK_MESSAGE(report[phase].get<double>() >= 0.0, phase);
    }
}

TEST_CASE("A grid of 30 by 30 takes 1861 operators and no more than 100 bytes an edge")
{
    const Run run = cremona({"bench", "halfedge", "--n", "30", "--json"});
    REQUIRE(run.status == 0);
    const auto report = nlohmann::json::parse(run.out);
    CHECK(report["operators"] == 2 * 30 * 30 + 2 * 30 + 1);
    CHECK(report["bytes_per_edge"].get<double>() <= 100.0);
    for (const char* phase : {"build", "build_journaled", "undo", "validate"})
        CHECK_MESSAGE(report[phase].get<double>() >= 0.0, phase);
    CHECK(has(cremona({"bench", "halfedge", "--n", "0"}).err, "--n: found \"0\"; wanted a whole number from 1 to"));
}

TEST_CASE("A meshed square has no angle below 30 degrees and about as many triangles as asked for")
{
    const auto report = nlohmann::json::parse(cremona({"bench", "mesh", "--triangles", "2000", "--json"}).out);
    CHECK(report["triangles"].get<double>() == doctest::Approx(2000.0).epsilon(0.1));
    CHECK(report["min_angle"].get<double>() >= 30.0);
    CHECK(report["vertices"].get<int>() > 1000);
}

TEST_CASE("A square of quadrilaterals sags at its side as independent programs have it")
{
    const auto report = nlohmann::json::parse(cremona({"bench", "plane", "--n", "100", "--json"}).out);
    CHECK(report["dofs"] == 20200);
    CHECK(report["tip"].get<double>() == doctest::Approx(6.8314657).epsilon(1e-8));
    CHECK(has(cremona({"bench", "plane", "--element", "Q7"}).err, "--element"));
}

TEST_CASE("A frame of no size, or another benchmark, is answered with what is wanted")
{
    CHECK(has(cremona({"bench", "frame", "--bays", "0"}).err, "--bays: found \"0\"; wanted a whole number from 1 to"));
    CHECK(cremona({"bench", "fram"}).err == "cremona bench: WHAT: there is no \"fram\"; did you mean \"frame\"?\n");
    CHECK(cremona({"bench"}).status == 2);
    CHECK(cremona({"bench"}).err ==
          "cremona bench: nothing to build is given; add `frame`, `halfedge`, `mesh`, `plane` or `regions`\n");
}

TEST_CASE("A frame that memory cannot hold is refused in the user's language")
{
    const std::string limit = "ulimit -v 800000; ";                       // kB
    if (cli_test::shell(limit + "cremona --version").status != 0) return; // a sanitizer takes more for itself
    const Run run = cli_test::shell(limit +
                                    "cremona bench frame --bays 400 --storeys 400 --solver multifrontal --lang pt");
    CHECK(run.status == 2);
    CHECK(run.out.empty());
    CHECK(has(run.err, "memória"));
}

TEST_CASE("The program ends where libraries would like more memory than is allowed")
{
    const std::string limit = "ulimit -v 200000; exec timeout 20 "; // kB
    const int status = cli_test::shell(limit + "cremona --version").status;
    if (status != 0 && status != 124) return; // a sanitizer takes more for itself
    CHECK(status == 0);
}

TEST_SUITE_END();
