// Documents of moment distribution: files, sheets turn by turn, and what they come to.
#include <doctest/doctest.h>

#include <cmath>

#include "apps/cross/document/file.h"
#include "apps/cross/document/solution.h"
#include "femoop/io/model_file.h"

using namespace cross;
namespace fc = femoop::cross;

namespace {

Document example(const std::string& name) { return read_document_file("examples/" + name + ".json"); }

double end_moment(const Solution& solution, const std::vector<double>& moments, const char* label)
{
    return moments[solution.task->problem.find_end(label)->index];
}

} // namespace

TEST_CASE("The document that the app begins with is the example on disk")
{
    CHECK(starting_document() == example("three_spans"));
}

TEST_CASE("Three spans with a pinned and a fixed end come to whole halves of a kilonewton metre")
{
    const Solution solution = solve(starting_document());
    REQUIRE(solution.task);
    const auto& equations = *solution.task->equations;
    CHECK(end_moment(solution, equations.moments, "BC") == doctest::Approx(86.5)); // th_B = -60/EI, th_C = 37.5/EI
    CHECK(end_moment(solution, equations.moments, "CD") == doctest::Approx(109.0));
    CHECK(end_moment(solution, equations.moments, "DC") == doctest::Approx(-71.5));
}

TEST_CASE("Turns by hand in the order of the largest unbalance write the sheet of that order")
{
    Document document = starting_document();
    Solution solution = solve(document);
    const fc::Sheet whole = fc::distribute(document.model, solution.task->problem, solution.task->problem.loading, {});
    document.plays.resize(1);
    for (std::size_t i = 0; i < whole.steps.size(); ++i) {
        document.plays[0].advance(*next_turn(document, solution));
        work(solution, document);
        const fc::State state = fc::state_after(solution.task->problem, whole, i + 1);
        CAPTURE(i);
        CHECK(solution.sheets[0].steps.back().joint == whole.steps[i].joint);
        for (std::size_t e = 0; e < state.moments.size(); ++e)
            CHECK(solution.sheets[0].end.moments[e] == doctest::Approx(state.moments[e]));
    }
    CHECK(solution.sheets[0].is_balanced);
}

TEST_CASE("All joints at once by hand write the rows of that order, rounded as on paper too")
{
    for (const int digits : {0, 3}) {
        Document document = starting_document();
        document.method.order = fc::Order::AllAtOnce;
        document.method.digits = digits;
        Solution solution = solve(document);
        document.plays.resize(1);
        for (int i = 0; i < 5; ++i) document.plays[0].advance(std::nullopt);
        work(solution, document);
        const fc::Sheet whole = fc::distribute(document.model, solution.task->problem, solution.task->problem.loading,
                                               {.order = fc::Order::AllAtOnce, .balances = 5, .digits = digits});
        CAPTURE(digits);
        for (std::size_t e = 0; e < whole.end.moments.size(); ++e) {
            CHECK(solution.sheets[0].end.moments[e] == doctest::Approx(whole.end.moments[e]));
        }
        for (std::size_t j = 0; j < whole.end.unbalance.size(); ++j) {
            CHECK(solution.sheets[0].end.rotations[j] == doctest::Approx(whole.end.rotations[j]));
            CHECK(solution.sheets[0].end.unbalance[j] == doctest::Approx(whole.end.unbalance[j]));
        }
    }
}

TEST_CASE("Left to right by hand goes on from the joint that was clicked")
{
    Document document = starting_document();
    document.method.order = fc::Order::LeftToRight;
    Solution solution = solve(document);
    document.plays.resize(1);
    document.plays[0].advance(fc::JointId(0));
    work(solution, document);
    CHECK(*next_turn(document, solution) == TurnTree::Turn(fc::JointId(1)));
    document.plays[0].advance(fc::JointId(1));
    work(solution, document);
    CHECK(*next_turn(document, solution) == TurnTree::Turn(fc::JointId(0)));
}

TEST_CASE("A joint on its way is a structure in equilibrium with half of its turn")
{
    Document document = starting_document();
    document.plays.resize(1);
    document.plays[0].advance(fc::JointId(1));
    const Solution solution = solve(document);
    const fc::Locks whole = present_locks(document, solution), half = present_locks(document, solution, 0.5);
    REQUIRE(whole.rotations[1] != 0.0);
    CHECK(half.rotations[1] == doctest::Approx(0.5 * whole.rotations[1]));
    CHECK(half.rotations[0] == 0.0);
}

TEST_CASE("A frame that sways has a sheet for the loads and one for each sway")
{
    Document document = example("portal");
    document.method.load_case = *document.model.find_case("W");
    const Solution solution = solve(document);
    REQUIRE(solution.task);
    CHECK(solution.sheets.size() == 2);
    REQUIRE(solution.task->comparison);
    for (std::size_t e = 0; e < solution.task->problem.ends.size(); ++e)
        CHECK(std::abs(solution.task->comparison->distributed[e] - solution.task->comparison->limit[e]) < 0.05);
}

TEST_CASE("A structure that cannot be distributed has faults and no task")
{
    const Solution solution = solve(example("grillage"));
    CHECK_FALSE(solution.task);
    CHECK_FALSE(solution.faults.empty());
    CHECK(solution.sheets.empty());
}

TEST_CASE("An arch on the line of thrust of its loads needs no prop: rounding is no force")
{
    const Document arch = example("three_hinged_arch");
    const Solution solution = solve(arch);
    REQUIRE(solution.task->problem.sways.size() == 6);
    for (const double held : held_by_props(arch, solution)) CHECK(held == 0.0);
}

TEST_CASE("The method is saved with the file and read back")
{
    Document document = starting_document();
    document.method = {.load_case = femoop::CaseId(0),
                       .order = fc::Order::Listed,
                       .joints = {"C", "B"},
                       .tolerance = 0.025,
                       .digits = 3,
                       .far_ends = fc::FarEnds::Plain};
    CHECK(read_document(write_document(document)).method == document.method);
}

TEST_CASE("A file whose method was not changed keeps its block as it was")
{
    const Document document = starting_document();
    CHECK(read_document(write_document(document)).model.extra == document.model.extra);
}

TEST_CASE("Every branch of every sheet is kept in the file, and where it stands")
{
    Document document = example("portal");
    document.method.load_case = *document.model.find_case("W");
    const fc::Problem problem = solve(document).task->problem;
    REQUIRE(problem.joints.size() == 2);
    const fc::JointId B(0), C(1);
    document.plays.resize(2);
    TurnTree& loads = document.plays[0];
    for (const TurnTree::Turn& turn : {TurnTree::Turn(B), TurnTree::Turn(C), TurnTree::Turn(B)}) loads.advance(turn);
    loads.jump(1);
    loads.advance(std::nullopt); // a branch: all at once
    loads.advance(C);
    loads.jump(1);
    loads.go_to(loads.branches().front());
    loads.jump(2);
    document.stage = 1;
    document.plays[1].advance(C);
    const Document again = read_document(write_document(document));
    CHECK(again.method == document.method);
    CHECK(again.stage == 1);
    REQUIRE(again.plays.size() == 2);
    CHECK(again.plays[0].branches().size() == 2);
    CHECK(again.plays[0].turns() == loads.turns());
    CHECK(again.plays[0].n_ahead() == 1);
    for (std::size_t i = 0; i < 2; ++i)
        CHECK(again.plays[0].turns_to(again.plays[0].branches()[i]) == loads.turns_to(loads.branches()[i]));
    CHECK(again.plays[1].turns() == document.plays[1].turns());
    CHECK(again.model.extra == read_document(write_document(unworked(document))).model.extra);
    CHECK(write_document(again) == write_document(document));
}

TEST_CASE("Turns of joints that a file's structure does not have are left out with what follows them")
{
    std::string text = write_document(starting_document());
    const auto with = [&](const std::string& worked) {
        std::string file = text;
        file.insert(file.rfind("\"order\""), "\"worked\": " + worked + ", ");
        return file;
    };
    const Document some = read_document(with(
        R"({"sheet": 7, "plays": [{"ways": [["B", "C", "Z", "B"], ["A"], []], "way": 0, "at": 9}, {}, {"way": 3}]})"));
    CHECK(some.stage == 0);
    REQUIRE(some.plays.size() == 1); // the beam does not sway
    CHECK(some.plays[0].length() == 2);
    for (const std::string worked :
         {"3", "[]", R"({"plays": 1})", R"({"plays": [2]})", R"({"plays": [{"ways": "B"}]})",
          R"({"plays": [{"ways": [["B", 2]]}]})", R"({"sheet": -1})", R"({"sheet": 1e300})"}) {
        CAPTURE(worked);
        CHECK_THROWS_WITH_AS(read_document(with(worked)), doctest::Contains("cross"), femoop::ModelError);
    }
}
