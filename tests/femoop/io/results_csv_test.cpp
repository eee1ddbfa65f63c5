#include "femoop/io/results/results_csv.h"

#include <doctest/doctest.h>

#include "femoop/analysis/linear_static.h"
#include "tests/femoop/result/two_cases.h"

using namespace femoop;

TEST_SUITE_BEGIN("io");

TEST_CASE("A name with a comma or a quotation mark stays one cell")
{
    Model model = two_cases();
    model.nodes[0].id = "left, \"A\"";
    const auto files = results_csv(model, analyse(model), {CaseId(0)}, 2);
    CHECK(files[0].name == "displacements.csv");
    CHECK(files[0].text.find("\nP,\"left, \"\"A\"\"\",0,0,") != std::string::npos);
}

TEST_CASE("A node and a case named like formulas stay words in every table")
{
    Model model = two_cases();
    model.nodes[0].id = "=A";
    model.load_cases[0].id = "-P";
    const Results results = analyse(model);
    CHECK(results_csv(model, results, {CaseId(0)}, 2)[0].text.find("\n'-P,'=A,0,0,") != std::string::npos);
    CHECK(long_csv(model, results, {CaseId(0)}, 2).find("\n'-P,node,'=A,,ux,0,m\n") != std::string::npos);
}

TEST_CASE("The members' table has a row for each station, two where a force jumps")
{
    const Model model = two_cases();
    const std::string text = results_csv(model, analyse(model), {CaseId(0)}, 2)[2].text;
    CHECK(text.find("case,member,x [m],N [kN],V [kN],M [kN*m],u [m],v [m]\n") == 0);
    CHECK(std::count(text.begin(), text.end(), '\n') == 1 + 4); // heading, 0, 2 twice, 8
}

TEST_CASE("The long table gives every value a unit: lengths, angles, forces and moments apart")
{
    const Model model = two_cases();
    const std::string text = long_csv(model, analyse(model), {CaseId(0)}, 2);
    for (const char* row : {"P,node,A,,ux,0,m\n", "P,node,A,,fy,22.5,kN\n", ",rad\n", "P,member,AB,2,M,45,kN*m\n"})
        CHECK_MESSAGE(text.find(row) != std::string::npos, row);
}

TEST_SUITE_END();
