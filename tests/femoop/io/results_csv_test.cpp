#include "femoop/io/results/results_csv.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "femoop/analysis/linear_static.h"
#include "femoop/io/model_file.h"
#include "femoop/tabular/separated.h"
#include "tests/femoop/result/two_cases.h"
#include "tests/source_folder.h"

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

namespace {

/// The numbers of one case of the long table.
std::vector<double> values_of(const std::string& long_table, std::string_view load_case)
{
    std::vector<double> values;
    for (const std::vector<std::string>& row : tabular::read_separated(long_table, ','))
        if (row.front() == load_case) values.push_back(std::stod(row.at(5)));
    return values;
}

} // namespace

TEST_CASE("What rounding alone has left is 0 in every table, and what is small because its loads are is not")
{
    // By symmetry its crown moves straight down, and its hinges carry no moment.
    Model model = read_model_file(source_folder() + "/examples/three_hinged_arch.json");
    model.combinations.push_back({.id = "tiny", .terms = {{CaseId(0), 1.0e-15}}});
    const Results results = analyse(model);
    const std::string table = long_csv(model, results, {CaseId(0), CaseId(2)}, 5);
    const std::vector<double> whole = values_of(table, model.case_name(CaseId(0))), tiny = values_of(table, "tiny");
    REQUIRE(whole.size() == tiny.size());
    std::size_t n_zeros = 0;
    for (std::size_t i = 0; i < whole.size(); ++i) {
        CAPTURE(i);
        const bool is_zero = whole[i] == 0.0;
        if (is_zero) ++n_zeros;
        CHECK((is_zero || std::abs(whole[i]) > 1.0e-13));
        CHECK((tiny[i] == 0.0) == is_zero);
    }
    CHECK(n_zeros > 50);
    for (const CsvFile& file : results_csv(model, results, {CaseId(0)}, 5)) {
        CAPTURE(file.name);
        if (file.name != "equilibrium.csv") CHECK(file.text.find("e-1") == std::string::npos); // the residual is small
    }
    for (const CsvFile& file : envelope_csv(model, results, {CaseId(0)}))
        CHECK_MESSAGE(file.text.find("e-1") == std::string::npos, file.name);
    CHECK(long_envelope_csv(model, results, {CaseId(0)}, 5).find("e-1") == std::string::npos);
}

TEST_SUITE_END();
