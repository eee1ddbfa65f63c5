#include <doctest/doctest.h>

#include <cmath>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "femoop/analysis/linear_static.h"
#include "femoop/io/free_body/free_body_text.h"
#include "femoop/io/model_file.h"
#include "tests/frame_maker.h"

using namespace femoop;
using namespace femoop::free_body;

namespace {

/// A cantilever from A under 12 kN/m and 30 kN at 3 m, cut at 2 m.
Model held_beam()
{
    FrameMaker made;
    made.node("A", 0, 0, SupportKind::Fixed)
        .node("B", 5, 0)
        .member("A", "B")
        .uniform("AB", -12.0)
        .point("AB", 3.0, -30.0);
    return made.model;
}

/// Of the numbers before the last "= 0".
double printed_sum(const std::string& line)
{
    const std::size_t end = line.rfind(" = 0 ");
    if (end == std::string::npos) return 0.0; // the arms of the next line
    const std::size_t begin = line.rfind("= ", end - 1);
    if (begin == std::string::npos) return 0.0;
    std::istringstream words(line.substr(begin + 2, end - begin - 2));
    double sum = 0.0, sign = 1.0;
    for (std::string word; words >> word;) {
        if (word == "+" || word == "−") sign = word == "+" ? 1.0 : -1.0;
        else if (word.starts_with("−")) sum -= std::stod(word.substr(std::string_view("−").size()));
        else sum += sign * std::stod(word);
    }
    return sum;
}

FreeBody right_part(const Model& model)
{
    const std::vector<Cut> cuts{{MemberId(0), 2.0}};
    const std::vector<NodeId> beside{NodeId(1)};
    return lift_out(model, analyse(model), CaseId(0), body_of(discretise(model), cuts, beside));
}

} // namespace

TEST_CASE("The forces on a body stand in a table that adds up to nothing, and in its equations")
{
    const Model model = held_beam();
    CHECK(free_body_text(right_part(model), model, {2.0, 0.0, 0.0}, english) ==
          "Free body: node B; member AB from x = 2 m to x = 5 m\n"
          "Moments about (2, 0) m\n"
          "\n"
          "  acts on the body          Fx [kN]   Fy [kN]\n"
          "  load on AB at x = 3 m           0  -30.0000\n"
          "  load on AB at x = 3.5 m         0  -36.0000\n"
          "  section of AB at x = 2 m        0   66.0000\n"
          "  sum                             0    0\n"
          "\n"
          "  turns the body                force [kN]  arm [m]  M [kN·m]\n"
          "  load on AB at x = 3 m     fy    -30.0000  1.00000  -30.0000\n"
          "  load on AB at x = 3.5 m   fy    -36.0000  1.50000  -54.0000\n"
          "  section of AB at x = 2 m  M                         84.0000\n"
          "  sum                                                  0\n"
          "\n"
          "ΣFx = 0  [kN]\n"
          "ΣFy = −30 − 36 + 66 = 0  [kN]\n"
          "ΣM(2, 0) = −30 kN · 1 m − 36 kN · 1.5 m + 84 kN·m\n"
          "= −30 − 54 + 84 = 0  [kN·m]\n");
}

TEST_CASE("Round-off of a load that stands on another support is no force on a body")
{
    FrameMaker made({.id = "girder", .A = 0.04, .Iz = 0.006}, {.id = "steel", .E = 2.1e8});
    made.node("A", 0, 0, SupportKind::Pin).node("B", 10, 0, SupportKind::Roller);
    made.node("C", 22.5, 0, SupportKind::Roller).node("D", 32.5, 0, SupportKind::Roller);
    made.member("A", "B").member("B", "C").member("C", "D").point("AB", 0.0, -1.0);
    const Results results = analyse(made.model);
    CHECK(results[CaseId(0)].curve(MemberId(1)).value(MemberComponent::Mz, 0.0) != 0.0); // 4e-16
    CHECK(lift_out(made.model, results, CaseId(0), body_of(NodeId(1))).forces.empty());
    CHECK(lift_out(made.model, results, CaseId(0), body_of(NodeId(0))).forces.size() == 2);
}

TEST_CASE("Moments about another point have the arms of all forces")
{
    const Model model = held_beam();
    const auto lines = equation_lines(right_part(model), model, {5.0, 0.0, 0.0}, english);
    REQUIRE(lines.size() == 4);
    // the section force V acts 3 m from there, and M of the section as it is
    CHECK(lines[2] == "ΣM(5, 0) = 30 kN · 2 m + 36 kN · 1.5 m − 66 kN · 3 m + 84 kN·m");
    CHECK(lines[3] == "= 60 + 54 − 198 + 84 = 0  [kN·m]");
    const auto below = equation_lines(right_part(model), model, {5.0, -3.25, 0.0}, english);
    CHECK(below[2].starts_with("ΣM(5, −3.25) = "));
}

TEST_CASE("Equations add up to nothing as printed, also where each number is rounded")
{
    FrameMaker made; // 10 kN on a third of the span: V = 10 / 3 and 20 / 3
    made.node("A", 0, 0, SupportKind::Pin).node("B", 3, 0).node("C", 9, 0, SupportKind::Roller);
    made.member("A", "B").member("B", "C").force("B", Dof::uy, -10.0).uniform("BC", -1.0 / 7.0);
    const Results results = analyse(made.model);
    const FreeBody whole = lift_out(made.model, results, CaseId(0),
                                    body_of(discretise(made.model), std::vector{MemberId(0), MemberId(1)}));
    const FreeBody node = lift_out(made.model, results, CaseId(0), body_of(NodeId(1)));
    int n_sums = 0;
    for (const FreeBody& body : {whole, node})
        for (int i = 0; i < 20; ++i)
            for (const std::string& line : equation_lines(body, made.model, {0.37 * i, 1.0 / 3.0, 0.0}, english)) {
                CAPTURE(line);
                n_sums += line.find(" = 0  [") != std::string::npos ? 1 : 0;
                CHECK(std::abs(printed_sum(line)) < 1e-11);
            }
    CHECK(n_sums == 2 * 20 * 3);
}

TEST_CASE(
    "In N and mm the numbers of an equation are whole, closed by one in their last digit, and a moment is one number")
{
    FrameMaker made({.id = "tube", .A = 2000.0, .Iz = 2e7}, {.id = "steel", .E = 2e5});
    made.model.units = {.length = LengthUnit::mm, .force = ForceUnit::N};
    made.node("A", 0, 0, SupportKind::Pin).node("C", 3000, 0).node("B", 6000, 0, SupportKind::Roller);
    made.member("A", "C").member("C", "B").force("C", Dof::uy, -10000.0).force("C", Dof::rz, -132195.0);
    made.uniform("AC", -1.2345);
    const std::vector<Cut> cuts{{MemberId(1), 1723.7}};
    const std::vector<NodeId> beside{NodeId(0)};
    const FreeBody body = lift_out(made.model, analyse(made.model), CaseId(0),
                                   body_of(discretise(made.model), cuts, beside));
    const auto lines = equation_lines(body, made.model, {123.456, 0.0, 0.0}, english);
    REQUIRE(lines.size() == 4);
    CHECK(lines[2] == "ΣM(123.456, 0) = −7755.59 N · 123.456 mm − 10000 N · 2876.54 mm − 132195 N·mm "
                      "− 3703.5 N · 1376.54 mm + 5947.91 N · 4600.24 mm + 7591314 N·mm");
    CHECK(lines[3].find("e+") == std::string::npos);
    CHECK(lines[3].find(" − 132195 ") != std::string::npos);
    CHECK(std::abs(printed_sum(lines[3])) < 1e-9);
    std::istringstream words(lines[3]);
    std::string sign, number;
    words >> sign >> number; // "=", "−957474"
    const double moment_of_reaction = body.forces.front().force.y() * 123.456;
    CHECK(std::abs(std::stod(number.substr(std::string_view("−").size())) - moment_of_reaction) <= 1.0);
    words >> sign >> number;
    CHECK(std::abs(std::stod(number) - 10000.0 * 2876.544) <= 1.0);
}

TEST_CASE("For LaTeX the equations of a body begin with a sum's sign, and its tables have the numbers of the text")
{
    const Model model = held_beam();
    const std::string latex = free_body_latex(right_part(model), model, {2.0, 0.0, 0.0}, english);
    CHECK(latex.starts_with(
        "\\section*{Free body: node B; member AB from x = 2 m to x = 5 m}\nMoments about (2, 0) m\n"));
    const auto has = [&](std::string_view part) { return latex.find(part) != std::string::npos; };
    CHECK(has("\\par\\noindent \\ensuremath{\\sum F_y} = "));
    CHECK(has("\\par\\noindent \\ensuremath{\\sum M}(2, 0) = \\ensuremath{-}30 kN"));
    CHECK(has("section of AB at x = 2 m & 0 & 66 \\\\\n"));
    CHECK(!has("Σ"));
}

TEST_CASE("Round-off that a hinge has for a moment is 0 in its equation")
{
    const Model model = read_model_file("examples/three_hinged_arch.json");
    const FreeBody hinge = lift_out(model, analyse(model), CaseId(0), body_of(*model.find_node("E")));
    const std::vector<std::string> lines = equation_lines(hinge, model, usual_moment_point(hinge, model), english);
    CHECK(lines.back() == "ΣM(12, 6) = 0  [kN·m]");
}
