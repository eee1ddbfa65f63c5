// Sheets that others worked and published, line by line.
#include <doctest/doctest.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "femoop/methods/cross/state_model.h"
#include "femoop/methods/cross/turns.h"
#include "tests/femoop/methods/cross/frames.h"

using namespace femoop;
using namespace femoop::cross;
using doctest::Approx;

namespace {

/// A sheet as it is printed: the columns, then one line for every row, in which "." is an empty place.
struct Printed {
    std::string columns;
    std::vector<std::string> lines;
    double last_digit = 0.01;
    double sign = 1.0; ///< -1: moments are clockwise positive there
};

std::vector<std::string> words_of(const std::string& line)
{
    std::istringstream text(line);
    std::vector<std::string> words;
    for (std::string word; text >> word;) words.push_back(word);
    return words;
}

std::string name_of(RowKind kind)
{
    switch (kind) {
    case RowKind::FixedEnd: return "FEM";
    case RowKind::Balance: return "BAL";
    case RowKind::CarryOver: return "CO";
    case RowKind::Total: return "SUM";
    }
    return "";
}

/// Every number of every line, to the last digit that is printed.
void check_lines(const Problem& problem, const std::vector<Row>& rows, const Printed& printed)
{
    const std::vector<std::string> columns = words_of(printed.columns);
    REQUIRE(rows.size() == printed.lines.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        CAPTURE(printed.lines[i]);
        const std::vector<std::string> words = words_of(printed.lines[i]);
        REQUIRE(words.size() == columns.size() + 1);
        CHECK(words[0] == name_of(rows[i].kind));
        for (std::size_t c = 0; c < columns.size(); ++c) {
            CAPTURE(columns[c]);
            const double wanted = words[c + 1] == "." ? 0.0 : std::stod(words[c + 1]);
            const double found = printed.sign * rows[i].values[problem.find_end(columns[c]).value().index];
            CHECK(std::abs(found - wanted) <= 0.51 * printed.last_digit);
        }
    }
}

Sheet worked(const Model& model, const Problem& problem, Procedure procedure, std::size_t n_balances)
{
    procedure.balances = n_balances;
    procedure.ends_with_balance = true;
    return distribute(model, problem, problem.loading, procedure);
}

/// A member whose EI is `times` that of the others.
void stiffen(FrameMaker& made, const std::string& id, double times)
{
    const SectionId section = made.model.add(Section{.id = id, .A = 0.01, .Iz = 1e-4 * times});
    made.model.members[made.model.find_member(id)->index].section = section;
}

/// w0 [force/length] at the member's start to w1 at its end.
void triangle(FrameMaker& made, const std::string& id, double w0, double w1)
{
    DistributedLoad load;
    load.values.push_back({.dof = Dof::uy, .start = w0, .end = w1});
    made.model.load_cases[0].members.push_back({.member = *made.model.find_member(id), .load = load});
}

/// T. B. Quimby's beam: ft and kip, columns of 10 ft with I = 200 in4 below every joint, which is propped sideways.
Model beam_on_columns()
{
    FrameMaker made;
    made.node("A", 0, 10).node("B", 15, 10).node("C", 30, 10).node("D", 60, 10);
    made.node("a", 0, 0, fixed).node("b", 15, 0, fixed).node("c", 30, 0, fixed).node("d", 60, 0, fixed);
    made.member("A", "B").member("B", "C").member("C", "D");
    made.member("A", "a").member("B", "b").member("C", "c").member("D", "d");
    stiffen(made, "AB", 510.0 / 200.0);
    stiffen(made, "BC", 480.0 / 200.0);
    stiffen(made, "CD", 754.0 / 200.0);
    made.uniform("AB", -2.0).uniform("BC", -1.4).uniform("CD", -1.6);
    made.point("AB", 5, -15).point("BC", 7, -20).point("CD", 12, -5);
    return made.model;
}

/// MATHalino's problem 884: an overhang of 1 m, spans of 4, 4 and 3 m, the last support fixed.
Model overhanging_beam()
{
    FrameMaker made;
    made.node("0", 0, 0).node("1", 1, 0, pin).node("2", 5, 0, roller).node("3", 9, 0, roller).node("4", 12, 0, fixed);
    made.member("0", "1").member("1", "2").member("2", "3").member("3", "4");
    made.uniform("01", -4000).uniform("12", -4000).point("23", 1, -2000).point("23", 3, -2000);
    triangle(made, "34", 0, -6000);
    return made.model;
}

/// Five bays on fixed columns. The sheet gives neither lengths nor stiffnesses: those of the beams to those of the
/// columns are as 0.5628 to 1, which is what its factors 0.36 and 0.26 and its first balance leave.
Model deck_floor()
{
    constexpr double L = 6.0, fixed_end = 46.333;
    FrameMaker made;
    const std::string joints = "123456", feet = "ABCDEF";
    for (std::size_t i = 0; i < joints.size(); ++i) {
        made.node({joints[i]}, L * static_cast<double>(i), L).node({feet[i]}, L * static_cast<double>(i), 0, fixed);
        made.member({joints[i]}, {feet[i]});
    }
    for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
        made.member({joints[i]}, {joints[i + 1]});
        stiffen(made, {joints[i], joints[i + 1]}, 0.5628);
        made.uniform({joints[i], joints[i + 1]}, -12.0 * fixed_end / (L * L));
    }
    return made.model;
}

} // namespace

// T. B. Quimby, A Beginner's Guide to Structural Analysis & Mechanics, example CB.1 (spreadsheet of 1 August 2008),
// read as far as a stored copy goes (scribd.com/document/370177598): five balances. Its lines "Sum" are left out.
TEST_CASE("Quimby's example CB.1, three spans on columns: every line of the sheet to a thousandth")
{
    const Model model = beam_on_columns();
    const Problem problem = problem_of(model, CaseId(0));
    const Sheet sheet = worked(model, problem, {.order = Order::AllAtOnce}, 5);
    const Printed printed{.columns = "Aa AB BA Bb BC CB Cc CD DC Dd",
                          .lines = {"FEM 0 70.833 -54.167 0 66.072 -61.094 0 141.600 -134.400 0",
                                    "BAL -26.235 -44.599 -4.707 -2.769 -4.430 -33.399 -20.874 -26.232 74.843 59.557",
                                    "CO . -2.353 -22.299 . -16.700 -2.215 . 37.422 -13.116 .",
                                    "BAL 0.872 1.482 15.418 9.070 14.511 -14.606 -9.129 -11.472 7.304 5.812",
                                    "CO . 7.709 0.741 . -7.303 7.256 . 3.652 -5.736 .",
                                    "BAL -2.855 -4.854 2.594 1.526 2.442 -4.525 -2.828 -3.554 3.194 2.542",
                                    "CO . 1.297 -2.427 . -2.263 1.221 . 1.597 -1.777 .",
                                    "BAL -0.480 -0.817 1.854 1.091 1.745 -1.169 -0.731 -0.918 0.990 0.787",
                                    "CO . 0.927 -0.408 . -0.585 0.872 . 0.495 -0.459 .",
                                    "BAL -0.343 -0.584 0.393 0.231 0.369 -0.567 -0.355 -0.446 0.256 0.203"},
                          .last_digit = 0.001};
    std::vector<Row> rows = rows_of(problem, sheet);
    rows.pop_back(); // the copy ends before the totals
    check_lines(problem, rows, printed);
    const double factors[] = {0.370, 0.630, 0.395, 0.233, 0.372, 0.415, 0.259, 0.326, 0.557, 0.443};
    std::size_t i = 0;
    for (const std::string& end : words_of(printed.columns))
        CHECK(problem[*problem.find_end(end)].factor == Approx(factors[i++]).epsilon(0.002));
}

// MATHalino.com, "Solution to Problem 884 by Moment Distribution Method", a spreadsheet of two sheets (node 3269), read
// as a stored copy (scribd.com/document/435374956).
TEST_CASE("MATHalino's problem 884, all joints at once: the overhang is released once, every line to a hundredth")
{
    const Model model = overhanging_beam();
    const Problem problem = problem_of(model, CaseId(0), FarEnds::ReleasedOnSheet);
    const Sheet sheet = worked(model, problem, {.order = Order::AllAtOnce}, 11);
    check_lines(problem, rows_of(problem, sheet),
                {.columns = "10 12 21 23 32 34 43",
                 .lines = {"FEM 2000.00 -5333.33 5333.33 -1500.00 1500.00 -1800.00 2700.00",
                           "BAL . 3333.33 -1642.86 -2190.48 128.57 171.43 .",
                           "CO . . 1666.67 64.29 -1095.24 . 85.71",
                           "BAL . . -741.84 -989.12 469.39 625.85 .",
                           "CO . . . 234.69 -494.56 . 312.93",
                           "BAL . . -100.58 -134.11 211.95 282.60 .",
                           "CO . . . 105.98 -67.06 . 141.30",
                           "BAL . . -45.42 -60.56 28.74 38.32 .",
                           "CO . . . 14.37 -30.28 . 19.16",
                           "BAL . . -6.16 -8.21 12.98 17.30 .",
                           "CO . . . 6.49 -4.11 . 8.65",
                           "BAL . . -2.78 -3.71 1.76 2.35 .",
                           "CO . . . 0.88 -1.85 . 1.17",
                           "BAL . . -0.38 -0.50 0.79 1.06 .",
                           "CO . . . 0.40 -0.25 . 0.53",
                           "BAL . . -0.17 -0.23 0.11 0.14 .",
                           "CO . . . 0.05 -0.11 . 0.07",
                           "BAL . . -0.02 -0.03 0.05 0.06 .",
                           "CO . . . 0.02 -0.02 . 0.03",
                           "BAL . . -0.01 -0.01 0.01 0.01 .",
                           "CO . . . 0.00 -0.01 . 0.00",
                           "BAL . . 0.00 0.00 0.00 0.00 .",
                           "SUM 2000.00 -2000.00 4459.78 -4459.78 660.87 -660.87 3269.56"},
                 .sign = -1.0});
}

TEST_CASE("MATHalino's problem 884, one joint after another: 1, 3, then 2 and 3 in turn")
{
    const Model model = overhanging_beam();
    const Problem problem = problem_of(model, CaseId(0), FarEnds::ReleasedOnSheet);
    std::vector<Turn> turns;
    for (const char joint : std::string("132323232323"))
        turns.emplace_back(problem.joint_at(*model.find_node(std::string(1, joint))));
    const Sheet sheet = sheet_of(problem, problem.loading, turns, {});
    // A balance and its carry-overs stand on one line there.
    const Printed printed{.columns = "10 12 21 23 32 34 43",
                          .lines = {". 3333.33 1666.67 . . . .", ". . . 64.29 128.57 171.43 85.71",
                                    ". . -2384.69 -3179.59 -1589.80 . .", ". . . 340.67 681.34 908.45 454.23",
                                    ". . -146.00 -194.67 -97.33 . .", ". . . 20.86 41.71 55.62 27.81",
                                    ". . -8.94 -11.92 -5.96 . .", ". . . 1.28 2.55 3.41 1.70",
                                    ". . -0.55 -0.73 -0.36 . .", ". . . 0.08 0.16 0.21 0.10",
                                    ". . -0.03 -0.04 -0.02 . .", ". . . 0.00 0.01 0.01 0.01"}};
    const std::vector<std::string> columns = words_of(printed.columns);
    REQUIRE(sheet.steps.size() == printed.lines.size());
    for (std::size_t n = 0; n < sheet.steps.size(); ++n) {
        CAPTURE(printed.lines[n]);
        std::vector<double> line(problem.ends.size(), 0.0);
        for (const Change& change : sheet.balanced(sheet.steps[n])) line[change.end.index] -= change.value;
        for (const Change& change : sheet.carried_over(sheet.steps[n])) line[change.end.index] -= change.value;
        const std::vector<std::string> words = words_of(printed.lines[n]);
        for (std::size_t c = 0; c < columns.size(); ++c) {
            const double wanted = words[c] == "." ? 0.0 : std::stod(words[c]);
            CHECK(std::abs(line[problem.find_end(columns[c])->index] - wanted) <= 0.51 * printed.last_digit);
        }
    }
    const std::pair<const char*, double> sums[] = {{"21", 4459.78274}, {"32", 660.870398}, {"43", 3269.5648}};
    for (const auto& [end, sum] : sums)
        CHECK(-sheet.end.moments[problem.find_end(end)->index] == Approx(sum).epsilon(1e-5));
}

// "Deck floor, beam along A (dead load)": a sheet out of a student's design of a building, read as a stored copy
// (scribd.com/document/383816638, titled Moment Distribution Theory).
TEST_CASE("A deck floor of five bays on columns: every line of the sheet to a hundredth")
{
    const Model model = deck_floor();
    const Problem problem = problem_of(model, CaseId(0));
    const Sheet sheet = worked(model, problem, {.order = Order::AllAtOnce}, 6);
    check_lines(
        problem, rows_of(problem, sheet),
        {.columns = "1A 12 21 2B 23 32 3C 34 43 4D 45 54 5E 56 65 6F",
         .lines = {"FEM 0 46.33 -46.33 0 46.33 -46.33 0 46.33 -46.33 0 46.33 -46.33 0 46.33 -46.33 0",
                   "BAL -29.65 -16.69 0 0 0 0 0 0 0 0 0 0 0 0 16.69 29.65", "CO . 0 -8.34 . 0 0 . 0 0 . 0 0 . 8.34 0 .",
                   "BAL 0 0 2.21 3.92 2.21 0 0 0 0 0 0 -2.21 -3.92 -2.21 0 0",
                   "CO . 1.10 0 . 0 1.10 . 0 0 . -1.10 0 . 0 -1.10 .",
                   "BAL -0.71 -0.40 0 0 0 -0.29 -0.52 -0.29 0.29 0.52 0.29 0 0 0 0.40 0.71",
                   "CO . 0 -0.20 . -0.15 0 . 0.15 -0.15 . 0 0.15 . 0.20 0 .",
                   "BAL 0 0 0.09 0.16 0.09 -0.04 -0.07 -0.04 0.04 0.07 0.04 -0.09 -0.16 -0.09 0 0",
                   "CO . 0.05 0 . -0.02 0.05 . 0.02 -0.02 . -0.05 0.02 . 0 -0.05 .",
                   "BAL -0.03 -0.02 0.01 0.01 0.01 -0.02 -0.03 -0.02 0.02 0.03 0.02 -0.01 -0.01 -0.01 0.02 0.03",
                   "CO . 0 -0.01 . -0.01 0 . 0.01 -0.01 . 0 0.01 . 0.01 0 .",
                   "BAL 0 0 0 0.01 0 0 -0.01 0 0 0.01 0 0 -0.01 0 0 0",
                   ("SUM -30.39 30.39 -52.57 4.10 48.47 -45.53 "
                    "-0.62 46.16 -46.16 0.62 45.53 -48.47 -4.10 52.57 -30.39 30.39")}});
}

// "Método de Cross, aula 5", 2nd term of 2019, slides of a Brazilian course, read as a stored copy
// (scribd.com/document/605750253). Its factors 0.43 and 0.57 are rounded, which costs 0.02 kNm.
TEST_CASE("A Brazilian lecture's beam of two spans: 240 and 225 meet at 233.55, reactions 90.81 and 111.07")
{
    FrameMaker made;
    made.node("A", 0, 0, pin).node("B", 8, 0, roller).node("C", 14, 0, roller).member("A", "B").member("B", "C");
    made.uniform("AB", -30).uniform("BC", -50);
    const Problem problem = problem_of(made.model, CaseId(0));
    CHECK(problem.loading.fixed_end[problem.find_end("BA")->index] == Approx(-240.0));
    CHECK(problem.loading.fixed_end[problem.find_end("BC")->index] == Approx(225.0));
    CHECK(factors_of(problem, 2)[problem.find_end("BA")->index] == Approx(0.43));
    CHECK(factors_of(problem, 2)[problem.find_end("BC")->index] == Approx(0.57));
    const Sheet sheet = worked(made.model, problem, {.order = Order::AllAtOnce}, 1);
    CHECK(std::abs(sheet.end.moments[problem.find_end("BA")->index] + 233.55) < 0.025);
    const Results results = state_results(made.model, problem, locks_of(problem, sheet.end));
    const double reactions[] = {90.81, 149.19 + 188.93, 111.07};
    for (std::size_t n = 0; n < 3; ++n)
        CHECK(std::abs(results[state_case(results)].reaction(NodeId(n))[1] - reactions[n]) < 0.01);
}
